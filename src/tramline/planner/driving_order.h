#pragma once
// In which order the pieces are driven.

#include <vector>

#include "tramline/planner/candidate.h"

namespace tramline {

/// The pieces of a candidate in the order and the way round in which they are driven (order::best_tour()).
/// Connections between pieces are not planned.
std::vector<TrackPiece> driving_order(const SearchTask& task, const Candidate& candidate);

}  // namespace tramline
