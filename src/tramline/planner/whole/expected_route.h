#pragma once
// What the route of a plan is expected to cost, from routes of other plans of the same field.

#include "tramline/planner/whole/compared_plans.h"

namespace tramline {

/// What the route of any plan is expected to cost beyond its floor at the least, EUR: a part of the least of
/// all plans with a route; 0 where there is none. Not a bound. O(n).
double least_beyond_floor(const ComparedPlans& plans);

}  // namespace tramline
