#pragma once
// Assembles the result of a search into a plan that can be driven, written and drawn.

#include "tramline/planner/assembly/driven_tracks.h"
#include "tramline/planner/search_context.h"
#include "tramline/planner/search_result.h"

namespace tramline {

/// Throws kBadInput, naming the likely reason, where a candidate with this tally has no piece; except where
/// headland passes work more than the body, because a narrow field is worked by them alone.
void require_tracks(const SearchTask& task, const Tally& tally);

/// A plan with all that decides whether it is better than another one: its pieces in driving order, those
/// dropped, its turns or its route, its tally and its cost. What takes long and decides nothing is left out:
/// the overlap of single pieces, encounters, layers of polygons, the bounds and warnings.
struct PlanDraft {
  Plan plan;
  Driven driven;            ///< without pieces and route, which the plan has
  std::size_t parts = 1;    ///< of the land, which the route works one after the other
  bool gave_up = false;     ///< with more patience another order might have been found
  std::size_t reached = 0;  ///< by searches for ways of the route, as of PlannedRoute
};

/// The best candidate as a draft. Throws as require_tracks().
PlanDraft drafted(const SearchTask& task, const SearchResult& found);

/// A draft as a plan, with all that it lacks. `found`: what it was drafted from.
Plan finished(const SearchTask& task, SearchResult found, PlanDraft draft, const SearchContext& context);

/// The best candidate as a plan: drafted() and finished(). Throws as require_tracks().
Plan finished_plan(const SearchTask& task, SearchResult found, const SearchContext& context);

}  // namespace tramline
