#pragma once
// The route of a plan, in words and as JSON.

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "tramline/model/plan.h"
#include "tramline/planner/plan_field.h"

namespace tramline::app {

/// The key `route` (docs/json.md). Precondition: the plan has a route.
nlohmann::ordered_json route_json(const Plan& plan);

/// The key `whole_cost`. Precondition: the plan has a route.
nlohmann::ordered_json whole_cost_json(const Plan& plan);

/// The plans whose routes were compared: `directions_deg`, `headlands`, `all_round`, `hours`, `euros`,
/// `without_room`.
nlohmann::ordered_json compared_routes_json(const std::vector<RouteAlternative>& routes);
/// A table of them for people; "" where there are none.
std::string compared_routes_rows(const std::vector<RouteAlternative>& routes);

/// What the hours, the fuel and the land of the route cost in euros: a row of the summary; "" where no route
/// was planned.
std::string whole_cost_row(const Plan& plan);

/// Rows of the summary, two at most; "" where no route was planned.
std::string route_rows(const Plan& plan);

}  // namespace tramline::app
