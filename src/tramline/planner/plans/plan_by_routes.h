#pragma once
// The plan whose whole route costs least.

#include "tramline/planner/plans/searched_plan.h"

namespace tramline {

/// Layouts of least cost of their tracks, and what cheapest_route() makes of them. Throws as searched_plan(),
/// unless headlands follow turns and passes alone work the land. Precondition: compares_routes(settings).
ExplainedPlan plan_by_routes(const PlanningProblem& asked, const SearchContext& context, Explain explain);

}  // namespace tramline
