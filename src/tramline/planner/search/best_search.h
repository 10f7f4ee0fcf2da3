#pragma once
// The cheapest plan over all directions, offsets and divisions of the ground.

#include "tramline/planner/search_context.h"
#include "tramline/planner/search_result.h"

namespace tramline {

/// Each connected part of the ground with the best grid of all directions and offsets (branch_and_bound), and
/// divided where that pays (split_where_it_pays); S1's sweep, and its subfields with better grids and
/// joined where that pays; all with detours. The cheapest is kept: never costlier than sweep_search() for the
/// same task. Of plans that cost more than `no_more_than` any may be given, or none: nobody asks which is the
/// cheapest. Deterministic for any number of threads.
SearchResult best_search(const SearchTask& task, const SearchContext& context,
                         double no_more_than = kAnyCost);

/// No plan in which every piece that fits is driven costs less, whatever the subfields, directions, offsets
/// and detours: a track works at most w times the length it can have, so that many are needed, or land is
/// left.
double least_cost_of_any_plan(const SearchTask& task);

}  // namespace tramline
