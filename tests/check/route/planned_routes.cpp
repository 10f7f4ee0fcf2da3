#include "check/route/planned_routes.h"

#include <gtest/gtest.h>

#include <string>
#include <utility>
#include <vector>

#include "tramline/check/file/compare_warnings.h"
#include "tramline/check/verify.h"
#include "tramline/planner/plan_field.h"

namespace tramline::planned_routes {

Field field_of(Ring outer) {
  Field field;
  field.id = "drawn";
  field.outer = std::move(outer);
  return field;
}

Field l_shape() { return field_of({{0, 0}, {300, 0}, {300, 140}, {160, 140}, {160, 260}, {0, 260}}); }

Field with_lane(double lane_m) {
  return field_of({{0, 0},
                   {120, 0},
                   {120, 30},
                   {180, 30},
                   {180, 0},
                   {300, 0},
                   {300, 90},
                   {180, 90},
                   {180, 30 + lane_m},
                   {120, 30 + lane_m},
                   {120, 90},
                   {0, 90}});
}

Field with(Field field, Ring ring, ObstacleKind kind) {
  field.obstacles.push_back({{std::move(ring), {}}, kind, "drawn"});
  return field;
}

Machine machine(double width_m, double radius_m) {
  Machine out;
  out.width_m = width_m;
  out.radius_m = radius_m;
  return out;
}

Machine with_tractor(Machine of) {
  of.turning.implement_offset_m = 2;
  of.turning.rear_overhang_m = 1;
  of.turning.front_overhang_m = 3;
  of.turning.vehicle_width_m = 2.5;
  of.turning.lift_m = 1;
  of.turning.lower_m = 2;
  return of;
}

PlanSettings whole_route(int headlands) {
  PlanSettings settings;
  settings.turns = TurnPlanning::kRoute;
  settings.headlands = settings.obstacle_headlands = headlands;
  return settings;
}

Plan expect_route_holds(const Field& field, const Machine& of, const PlanSettings& settings) {
  Plan plan = plan_field(field, of, {}, settings);
  EXPECT_TRUE(plan.route.planned());
  const check::Verdict verdict = check::verify(plan);
  EXPECT_TRUE(verdict.complete);
  for (const check::Violation& v : verdict.violations) ADD_FAILURE() << name(v.rule) << ": " << v.what;
  return plan;
}

std::string first_warning_at_fault(const Plan& plan) {
  const std::vector<check::Violation> all = check::compare_warnings(plan);
  return all.empty() ? std::string() : all.front().what;
}

}  // namespace tramline::planned_routes
