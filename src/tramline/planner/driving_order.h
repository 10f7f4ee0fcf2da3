#pragma once
// In which order the pieces are driven.

#include <vector>

#include "tramline/planner/candidate.h"

namespace tramline {

/// The pieces of a candidate by subfield, track and place along it: not in driving order.
std::vector<TrackPiece> track_pieces(const Candidate& candidate);

/// The same in the order and the way round in which they are driven (order::best_tour()).
/// Connections between pieces are not planned.
std::vector<TrackPiece> driving_order(const SearchTask& task, const Candidate& candidate);

}  // namespace tramline
