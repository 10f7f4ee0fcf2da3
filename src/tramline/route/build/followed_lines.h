#pragma once
// The lines of a field that ways between tracks may follow.

#include <vector>

#include "tramline/model/plan.h"
#include "tramline/route/connection/driving_ground.h"
#include "tramline/route/connection/roadmap.h"

namespace tramline {

/// Headland passes; lines round the field and round obstacles that have no passes, as near to them as the
/// outline may be while it turns; and the tracks, to be driven along. Lines that leave the land are among
/// them: their parts are tested where a way comes along. O(headland) and O(pieces).
std::vector<FollowedLine> followed_lines(const Headland& headland, const std::vector<TrackPiece>& pieces,
                                         const Field& field, const DrivingGround& ground);

}  // namespace tramline
