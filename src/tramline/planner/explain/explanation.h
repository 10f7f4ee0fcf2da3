#pragma once
// Why a plan is the one that was chosen: what its cost is made of, and what the next best would have cost.

#include "tramline/model/explanation.h"
#include "tramline/planner/search_context.h"
#include "tramline/planner/search_result.h"

namespace tramline {

/// Of the best plan of a search. Runner-ups are up to five of the plans that the search has laid out or had
/// on its shortlists; of the latter, those that may be cheap enough are laid out here. From the best plan and
/// from one another they differ in the number of subfields, or by more than a degree in a direction.
/// Deterministic for any number of threads.
Explanation explanation_of(const SearchTask& task, const SearchResult& found, const SearchContext& context);

}  // namespace tramline
