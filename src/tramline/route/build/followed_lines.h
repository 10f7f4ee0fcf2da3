#pragma once
// The lines of a field that ways between tracks may follow.

#include <vector>

#include "tramline/model/plan.h"
#include "tramline/route/connection/roadmap.h"

namespace tramline {

/// Headland passes; lines_beside_boundaries(); and the tracks, to be driven along. Lines that leave the land
/// are among them: their parts are tested where a way comes along. O(headland) and O(pieces).
std::vector<FollowedLine> followed_lines(const Headland& headland, const std::vector<TrackPiece>& pieces,
                                         const std::vector<FollowedLine>& beside, const Machine& machine);

}  // namespace tramline
