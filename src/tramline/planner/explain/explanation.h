#pragma once
// Why a plan was chosen: what its cost is made of, and what the next best plans would have cost.

#include "tramline/model/explanation.h"
#include "tramline/planner/search_context.h"
#include "tramline/planner/search_result.h"

namespace tramline {

/// Explains the best plan of a search. The runner-ups are up to five of the plans that the search has laid
/// out or had on its shortlists; of the latter, those that may be cheap enough are laid out here. They differ
/// from the best plan and from one another in the number of subfields, or by more than a degree in a
/// direction. Deterministic for any number of threads.
Explanation explanation_of(const SearchTask& task, const SearchResult& found, const SearchContext& context);

}  // namespace tramline
