#pragma once
// Fields, machines and settings of the planner's routes that the verifier looks at.

#include <string>

#include "support/box_ring.h"
#include "tramline/model/field.h"
#include "tramline/model/machine.h"
#include "tramline/model/plan.h"

namespace tramline::planned_routes {

using testing_support::box;
Field field_of(Ring outer);
/// An L of 300 m x 260 m.
Field l_shape();
/// Two fields of 120 m x 90 m and the lane of 60 m between them.
Field with_lane(double lane_m);
Field with(Field field, Ring ring, ObstacleKind kind);
Machine machine(double width_m, double radius_m);
/// The machine with a tractor before its axle and an implement behind it.
Machine with_tractor(Machine of);
/// Settings of a plan with its route, and with these headlands along all boundaries.
PlanSettings whole_route(int headlands);
/// Plans the route, of which all holds, and returns the plan.
Plan expect_route_holds(const Field& field, const Machine& of, const PlanSettings& settings);
/// What is wrong with the warnings of a plan, first of all.
std::string first_warning_at_fault(const Plan& plan);

}  // namespace tramline::planned_routes
