#pragma once
// From what a search has found to a plan that can be driven, written and drawn.

#include "tramline/planner/search_context.h"
#include "tramline/planner/search_result.h"

namespace tramline {

/// Throws kBadInput where a candidate with this tally has no piece, saying why that may be; unless headland
/// passes work more than the body: a narrow field is worked by them alone.
void require_tracks(const SearchTask& task, const Tally& tally);

/// All that a plan has from its task.
Plan bare_plan(const SearchTask& task);

/// The best candidate as a plan: its pieces in driving order, what was decided at obstacles, the land worked
/// twice or left, warnings. Throws as require_tracks().
Plan finished_plan(const SearchTask& task, SearchResult found, const SearchContext& context);

}  // namespace tramline
