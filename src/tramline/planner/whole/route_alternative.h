#pragma once
// What is told of a plan that was compared by its route.

#include "tramline/planner/plan_field.h"

namespace tramline {

/// What is told of a plan that has a route.
/// Of plans of one kind and as many passes, in directions that are about the same, the first alone.
std::vector<RouteAlternative> without_alike(const std::vector<RouteAlternative>& all);
RouteAlternative alternative_of(Alternative kind, const Plan& plan);

}  // namespace tramline
