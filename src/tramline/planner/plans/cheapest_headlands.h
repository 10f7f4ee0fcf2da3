#pragma once
// Headlands by the cost of the whole route, for tracks that are found by the cost of tracks.

#include "tramline/planner/headland_choice/headland_trial.h"
#include "tramline/planner/search_context.h"

namespace tramline {

/// The cheapest route of these: of the layout with the headlands that its turns need, with equal ones all
/// round and with fewer round obstacles; and of layouts looked for behind given numbers of passes round the
/// field, from one on as long as more of them cost less, and round obstacles. Only those numbers change that
/// follow from turns. `deepening`: for the headlands of the layout. Preconditions: headlands follow turns,
/// and routes are planned. Throws as searched_plan().
HeadlandTrial with_cheapest_headlands(const PlanningProblem& problem, const Plan& layout,
                                      const SearchContext& context, const SearchContext& deepening);

}  // namespace tramline
