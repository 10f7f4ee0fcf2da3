#pragma once
// What is told of a plan that was compared by its route.

#include "tramline/planner/plan_field.h"

namespace tramline {

/// What is told of a plan that has a route.
RouteAlternative alternative_of(Alternative kind, const Plan& plan);

}  // namespace tramline
