#pragma once
// From what a search has found to a plan that can be driven, written and drawn.

#include "tramline/planner/search_result.h"

namespace tramline {

/// Throws kBadInput where the candidate has no piece, saying why that may be.
void require_tracks(const SearchTask& task, const Candidate& candidate);

/// The best candidate as a plan: its pieces in driving order, what was decided at obstacles, the land worked
/// twice or left, warnings. Throws as require_tracks().
Plan finished_plan(const SearchTask& task, SearchResult found);

}  // namespace tramline
