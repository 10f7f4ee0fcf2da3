#pragma once
// What is told of a plan that was compared by its route.

#include <vector>

#include "tramline/planner/plan_field.h"

namespace tramline {

/// What is told of a plan that has a route.
RouteAlternative alternative_of(Alternative kind, const Plan& plan);

/// As they are told of: what is planned first, also where what is only told of costs less, then by what each
/// costs. Of plans of one kind and as many passes, in directions that are about the same, the first alone.
std::vector<RouteAlternative> in_order_told(std::vector<RouteAlternative> all, const Plan& planned);

}  // namespace tramline
