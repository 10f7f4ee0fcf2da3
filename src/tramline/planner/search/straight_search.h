#pragma once
// The search for straight tracks: that of the task's strategy, or tracks along a given line.

#include "tramline/planner/search_context.h"
#include "tramline/planner/search_result.h"

namespace tramline {

/// Searches by the task's strategy or along the guide. Plans that cost more than `no_more_than` need not be
/// found, because there is a cheaper one already. Precondition: the guide is empty or one straight line.
SearchResult straight_search(const SearchTask& task, const SearchContext& context,
                             double no_more_than = kAnyCost);

/// All parts undivided, with strips along the guide; line 0 of the grid lies on it, or on the
/// envelope's side that takes its place (Zhou §2.3.4).
SearchResult guided_search(const SearchTask& task);

}  // namespace tramline
