#pragma once
// Plans with S2's own construction of tracks.

#include "tramline/planner/curved_plan.h"

namespace tramline {

/// The tracks that S2 makes along the line (recursive_tracks.h), as a candidate for finished_plan(): the
/// reference is the line, extended across the ground, unsmoothed. Throws kBadInput where an obstacle has no
/// headland, or one is passable: S2 has a headland round every obstacle, which rows run into.
CurvedCandidate recursive_along(const SearchTask& task, const std::vector<Point>& line);

/// The same along the chain of edges that best_curved() follows; nullopt where it finds none.
std::optional<CurvedCandidate> recursive_along_best(const SearchTask& task, int threads);

}  // namespace tramline
