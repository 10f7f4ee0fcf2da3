#pragma once
// What the route of a plan is expected to cost, from routes of other plans of the same field.

#include "tramline/planner/whole/compared_plans.h"

namespace tramline {

/// What the route of a plan is expected to cost beyond its floor at the least, EUR: a part of the least of
/// all plans with a route; of few tracks also a larger part of the least of those in about the same
/// directions behind as many passes round the field, as more or fewer tracks have it, and of a moved grid of
/// not quite as few a still larger part of the least of such grids behind the same passes, once two have
/// their routes. 0 where no plan has a route. Not a bound. O(n · subfields²).
double least_beyond_floor(const ComparedPlans& plans, const ComparedPlan& plan);

}  // namespace tramline
