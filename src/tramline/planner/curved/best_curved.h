#pragma once
// The best tracks parallel to a curve (S2.11-S2.13).

#include <optional>
#include <vector>

#include "tramline/planner/candidate/candidate.h"
#include "tramline/planner/search_context.h"

namespace tramline {

struct BestCurve {
  Candidate candidate;
  std::vector<Point> line;  ///< what the curve of its largest part was made of
};

/// For each part of the ground the cheapest family along a chain of boundary edges between two corners, at
/// several levels of smoothing, the best of them moved sideways as well; detours are looked for in the
/// cheapest of these, and in those that would be if a stop cost no more than a turn. nullopt where no chain
/// is curved, or none has a track. Deterministic for any number of threads. O(parts · chains) families. With
/// S2's tracks to be made from the line chosen, which has to have ends, chains all the way round are left
/// out, and detours are not looked for.
std::optional<BestCurve> best_curved(const SearchTask& task, const SearchContext& context);

/// The same for some of the ground as the only subfield, along chains of its own edges.
std::optional<Candidate> best_along_own_edge(const SearchTask& task, const Polygon& ground,
                                             const SearchContext& context);

}  // namespace tramline
