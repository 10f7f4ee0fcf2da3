#pragma once
// Prepares a field for its searches: sorts obstacles and cuts off headlands (Zhou §2.3.3).

#include <optional>

#include "tramline/geometry/error.h"
#include "tramline/headland/headland.h"
#include "tramline/planner/planning_problem.h"
#include "tramline/planner/prepared_field.h"
#include "tramline/planner/search_context.h"
#include "tramline/planner/search_result.h"

namespace tramline {

/// The terms of the headlands that the settings ask for, with these passes round obstacles.
HeadlandTerms headland_terms(const PlanningProblem& problem, const std::vector<int>& obstacle_passes);

/// The field without headlands, whatever the settings ask for.
PreparedField field_without_headlands(const PlanningProblem& problem);

/// A field ready to be searched, with the search result already found on it, if any.
struct Preparation {
  PreparedField field;
  /// The result of straight_search() on this field. It is known where the search that determined which
  /// obstacles are gone round was made on this same field, that is where the field has headlands and no
  /// obstacle has. Its steps have not been counted.
  std::optional<SearchResult> found;
};

/// The field with the headlands that the settings ask for. An obstacle gets its passes unless tracks go round
/// it, that is unless in a plan of the same strategy without obstacle headlands every track that reaches it
/// goes round it. Where settings_decide_headlands() none is gone round. Where the passes cover the whole
/// field there is no body, and so there are no tracks. nullopt where there is no room for even one pass.
std::optional<Preparation> prepare_field(const PlanningProblem& problem, const SearchContext& context);

/// The field behind its own headland as the settings say and behind these passes round its obstacles; nullopt
/// where none has room.
std::optional<PreparedField> field_behind(const PlanningProblem& problem,
                                          const std::vector<int>& obstacle_passes);

/// The error for a field without room for even one pass.
Error no_room(const PlanningProblem& problem);

/// Whether the settings alone determine which obstacles have headlands, independently of the tracks. They do
/// under the end rule `cover`, which leaves no land uncovered, where all tracks are cut, with curved tracks,
/// and where no obstacle is to have a headland.
bool settings_decide_headlands(const PlanningProblem& problem);

}  // namespace tramline
