#pragma once
// The plan whose whole route costs least.

#include "tramline/planner/plans/searched_plan.h"

namespace tramline {

/// Layouts of least cost of their tracks, and what cheapest_route() makes of them. Where tracks may pass the
/// boundary and the plan backs out, hardly works the land or lacks room, the one within the boundary is taken
/// if it costs less; its settings say so. Throws as searched_plan(), unless headlands follow turns and passes
/// alone work the land. Precondition: compares_routes(settings).
ExplainedPlan plan_by_routes(const PlanningProblem& asked, const SearchContext& context, Explain explain);

}  // namespace tramline
