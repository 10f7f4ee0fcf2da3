#pragma once
// The plan whose whole route costs least, of several that a person would think of.

#include <vector>

#include "tramline/planner/plan_field.h"
#include "tramline/planner/planning_problem.h"
#include "tramline/planner/search_context.h"

namespace tramline {

/// Whether other plans than the one of least cost are to be compared by their routes.
bool compares_routes(const PlanSettings& settings);

struct ComparedRoutes {
  Plan plan;                          ///< the cheapest
  std::vector<RouteAlternative> all;  ///< `found` first, then as they were planned
};

/// Compares `found`, the plan of least cost with its route, with plans whose tracks all run along the longest
/// side of the field or along its length, and, where headlands follow from turns, with headlands of equal
/// depth all round: as many passes as the shallowest turn of the machine needs, and one more or less as long
/// as that costs less. Each is planned with its whole route. The cheapest in euros (whole_cost()) is taken,
/// where a leg without room costs what ten stops do; among equals the first. Deterministic for any number of
/// threads. Precondition: compares_routes(), and `found` has a route.
ComparedRoutes cheapest_route(const PlanningProblem& problem, Plan found, const SearchContext& context);

}  // namespace tramline
