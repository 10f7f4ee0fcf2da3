// The bounds of the routes that the planner makes hold, and two parts in a hundred more are refused.

#include <gtest/gtest.h>

#include <algorithm>
#include <utility>
#include <vector>

#include "check/route/planned_routes.h"
#include "tramline/check/verify.h"
#include "tramline/planner/plan_field.h"

namespace tramline::planned_routes {
namespace {

/// The bound of the plan holds, and two parts in a hundred more are refused. Returns the plan.
Plan with_bound_that_holds(Ring outer, const Machine& of, const PlanSettings& settings) {
  Plan plan = plan_field(field_of(std::move(outer)), of, {}, settings);
  const auto refused = [](const Plan& one) {
    const std::vector<check::Violation> all = check::verify(one).violations;
    return std::any_of(all.begin(), all.end(),
                       [](const check::Violation& v) { return v.rule == check::Rule::kRouteBound; });
  };
  EXPECT_FALSE(refused(plan));
  Plan claims_more = plan;
  claims_more.route.proof.bound_s *= 1.02;
  EXPECT_TRUE(refused(claims_more));
  return plan;
}

PlanSettings on_hard_land(Aim aim, int headlands) {
  PlanSettings out = whole_route(headlands);
  out.boundary = EdgeKind::kHard;
  out.aim = aim;
  return out;
}

Plan with_bound_that_holds(Ring outer, const Machine& of, Aim aim = Aim::kCost, int headlands = 0,
                           std::vector<Point> guide = {}) {
  PlanSettings settings = on_hard_land(aim, headlands);
  settings.guide = std::move(guide);
  return with_bound_that_holds(std::move(outer), of, settings);
}

// Where the machine backs out of its tracks the bound knows by how much, and the verifier too.
TEST(BoundsOfPlannedRoutes, know_the_sides_that_machines_back_from) {
  const Plan plan = with_bound_that_holds(box(0, 0, 60, 120), machine(6, 6));
  double time_s = 0;
  for (const RouteLeg& leg : plan.route.legs) time_s += leg.time_s;
  EXPECT_GT(plan.route.proof.bound_s, 0.97 * time_s);
  with_bound_that_holds({{0, 0}, {15, 0}, {16, 35}, {15, 70}, {0, 70}, {1, 35}}, machine(6, 6));
  Machine mounted = machine(6, 5);
  mounted.turning.front_overhang_m = 2;
  mounted.turning.vehicle_width_m = 2.5;
  mounted.turning.implement_offset_m = 1;
  with_bound_that_holds({{0, 0}, {70, 20}, {70, 80}, {0, 120}}, mounted);
}

// Without headlands each turn takes two stops, which the bound counts by their price. To back all along a
// track instead and stop once would take longer.
TEST(BoundsOfPlannedRoutes, count_stops_where_these_are_priced) {
  const Plan plan = with_bound_that_holds(box(0, 0, 60, 400), machine(6, 6), Aim::kWholeCost);
  const RouteSums sums = sums_of(plan.route);
  EXPECT_GT(sums.back_outs, 0U);
  EXPECT_GT(plan.route.proof.stop_s, 0);
  EXPECT_GT(plan.route.proof.bound_s, 0.97 * priced_time_s(plan.route));
  EXPECT_GT(plan.route.proof.bound_s, sums.time_s);
}

// The axle is 4 m ahead of a bar as long as half the field is wide: it can neither leave a track nor come to
// the next without a stop, from whatever side the gate lies.
TEST(BoundsOfPlannedRoutes, count_both_stops_of_implements_behind_the_axle) {
  Machine of = machine(12, 1);
  of.turning.implement_offset_m = 4;
  PlanSettings settings = whole_route(0);
  settings.boundary = EdgeKind::kHard;
  settings.aim = Aim::kWholeCost;
  settings.guide = {{0.5, 0}, {0.5, 41}};
  settings.route.end = Point{25, 10};
  const Plan plan = expect_route_holds(field_of(box(0, 0, 25, 41)), of, settings);
  EXPECT_GE(sums_of(plan.route).back_outs, 2U);
  EXPECT_GT(plan.route.proof.bound_s, 2 * plan.route.proof.stop_s);
}

// On a strip of 26 m the machine turns aside from a track along it to the pass along the edge only if it
// backs first, which the bound counts: were it not for that stop it would lie below 0.87 of the route.
TEST(BoundsOfPlannedRoutes, count_the_stop_before_a_closed_pass) {
  const Plan plan =
      with_bound_that_holds(box(0, 0, 26, 100), machine(6, 6), Aim::kWholeCost, 1, {{13, 0}, {13, 100}});
  ASSERT_TRUE(is_closed(plan.headland.passes.front()));
  EXPECT_GT(sums_of(plan.route).back_outs, 0U);
  EXPECT_GT(plan.route.proof.bound_s, 0.97 * priced_time_s(plan.route));
}

// On a strip of 9 m the passes go round corners at its ends, and the machine backs all along them, for it
// turns round nowhere.
TEST(BoundsOfPlannedRoutes, know_how_far_machines_back_round_corners) {
  PlanSettings settings = on_hard_land(Aim::kWholeCost, 0);
  settings.headland_rule = HeadlandRule::kTurns;
  const Plan plan = with_bound_that_holds({{0, 0}, {9.4, 0}, {9.4, 330}, {0, 326}}, machine(3, 6), settings);
  EXPECT_GT(plan.route.proof.bound_s, 0.9 * priced_time_s(plan.route));
}

}  // namespace
}  // namespace tramline::planned_routes
