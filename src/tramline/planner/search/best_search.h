#pragma once
// The search for the cheapest plan over all directions, offsets and divisions of the land.

#include "tramline/planner/search_context.h"
#include "tramline/planner/search_result.h"

namespace tramline {

/// Compares: each connected part of the land with its best grid over all directions and offsets
/// (branch_and_bound), also divided where that pays (split_where_it_pays); Versleijen's sweep; and the
/// sweep's subfields with better grids and joined where that pays; all with detours. The cheapest is kept,
/// which never costs more than sweep_search() for the same task. If every plan costs more than
/// `no_more_than`, the result may be any plan or none. Deterministic for any number of threads.
SearchResult best_search(const SearchTask& task, const SearchContext& context,
                         double no_more_than = kAnyCost);

}  // namespace tramline
