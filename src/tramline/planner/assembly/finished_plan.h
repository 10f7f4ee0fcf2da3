#pragma once
// Assembles the result of a search into a plan that can be driven, written and drawn.

#include "tramline/planner/search_context.h"
#include "tramline/planner/search_result.h"

namespace tramline {

/// Throws kBadInput, naming the likely reason, where a candidate with this tally has no piece; except where
/// headland passes work more than the body, because a narrow field is worked by them alone.
void require_tracks(const SearchTask& task, const Tally& tally);

/// A plan with everything that its task determines, without tracks.
Plan bare_plan(const SearchTask& task);

/// The best candidate as a plan: its pieces in driving order, the choices at obstacles, overlap, uncovered
/// land and warnings. Throws as require_tracks().
Plan finished_plan(const SearchTask& task, SearchResult found, const SearchContext& context);

}  // namespace tramline
