#pragma once
// In which order the pieces are driven.

#include <vector>

#include "tramline/planner/candidate.h"

namespace tramline {

/// Up and down the tracks of a subfield one after the other (boustrophedon), from the corner nearest
/// to where the machine is; then the nearest subfield not yet worked. The first subfield is the one
/// with index 0. Connections between pieces are not planned.
std::vector<TrackPiece> driving_order(const Candidate& candidate);

}  // namespace tramline
