#pragma once
// The headlands that a layout will need, found without laying its tracks anew.

#include "tramline/model/plan.h"
#include "tramline/planner/headland_choice/passes_by_boundary.h"
#include "tramline/planner/planning_problem.h"
#include "tramline/planner/search_context.h"

namespace tramline {

/// The number of passes along the boundary that has most of them.
int deepest(const PassesByBoundary& passes);

/// The passes with `more` of them, none above `most`.
PassesByBoundary sum_of(PassesByBoundary passes, const PassesByBoundary& more, int most);

/// Turns of a plan that have no room.
int turns_without_room(const Plan& plan);

/// The passes with which most turns find room between the tracks of the layout, cut back as the passes leave
/// them (shortened_tracks()): those given, and as many more as turns lack, a few times. Of equals the fewest.
/// None is above `most`. What the settings decide stays as it is.
PassesByBoundary foreseen_passes(const PlanningProblem& problem, const Plan& layout, PassesByBoundary passes,
                                 int most, const SearchContext& context);

}  // namespace tramline
