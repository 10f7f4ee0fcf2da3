#pragma once
// The route of a plan, in words and as JSON.

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "tramline/model/plan.h"

namespace tramline::app {

/// The key `route` (docs/json.md). Precondition: the plan has a route.
nlohmann::ordered_json route_json(const Plan& plan);

/// Rows of the summary, two at most; "" where no route was planned.
std::string route_rows(const Plan& plan);

}  // namespace tramline::app
