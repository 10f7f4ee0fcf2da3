#pragma once
// The best tracks parallel to a curve (Zhou §2.3.4).

#include <optional>
#include <vector>

#include "tramline/planner/candidate/candidate.h"
#include "tramline/planner/search_context.h"
#include "tramline/planner/search_result.h"

namespace tramline {

struct BestCurve {
  Candidate candidate;
  std::vector<Point> line;  ///< the line from which the curve of its largest part was made
};

/// For each part of the land the cheapest family along a chain of boundary edges between two corners, tried
/// at several levels of smoothing, the best of them also moved sideways. Detours are searched for in the
/// cheapest families, and in those that would be cheapest if a stop cost no more than a turn. nullopt where
/// no chain is curved, or none yields a track. Deterministic for any number of threads. O(parts · chains)
/// families. With Zhou's construction the chosen line needs ends, so chains all the way round are left out,
/// and detours are not searched for. On land in one piece without obstacles families moved sideways are
/// abandoned as soon as they are certain to cost more than `no_more_than`. What is found may cost more: its
/// route may cost less all the same.
std::optional<BestCurve> best_curved(const SearchTask& task, const SearchContext& context,
                                     double no_more_than = kAnyCost);

/// The same for one piece of the land as the only subfield, along chains of its own edges.
std::optional<Candidate> best_along_own_edge(const SearchTask& task, const Polygon& ground,
                                             const SearchContext& context, double no_more_than = kAnyCost);

}  // namespace tramline
