#pragma once
// A field made ready for its searches: obstacles sorted, headlands taken off (S2.5).

#include <optional>

#include "tramline/geometry/error.h"
#include "tramline/planner/planning_problem.h"
#include "tramline/planner/prepared_field.h"
#include "tramline/planner/search_context.h"
#include "tramline/planner/search_result.h"

namespace tramline {

/// The field as it is, whatever headlands are asked for.
PreparedField field_without_headlands(const PlanningProblem& problem);

/// A field ready to be searched, and what has been found on it already.
struct Preparation {
  PreparedField field;
  /// What straight_search() finds on it, where the search that has told which obstacles are gone round was of
  /// this very field: round the field there are headlands, and round no obstacle. Its steps have not been
  /// counted.
  std::optional<SearchResult> found;
};

/// The field with the headlands that the settings ask for. Obstacles get their passes unless tracks go round
/// them: those that every track goes round which meets them, in a plan of the same strategy without their
/// headlands. Where settings_decide_headlands() none is gone round. Where the passes take the whole field
/// there is no body, and so there are no tracks. nullopt where not even one pass has room.
std::optional<Preparation> prepare_field(const PlanningProblem& problem, const SearchContext& context);

/// What to tell a user for whom not even one pass has room.
Error no_room(const PlanningProblem& problem);

/// Do the settings alone say which obstacles have headlands, and not what tracks do there? Under the end rule
/// `cover`, which leaves nothing, where all tracks are cut, with curved tracks, and where no obstacle is to
/// have any.
bool settings_decide_headlands(const PlanningProblem& problem);

}  // namespace tramline
