// Whole routes of fields with arms hold: the machine backs out of them, mostly along what it has driven.

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "properties/seeds.h"
#include "tramline/check/verify.h"
#include "tramline/planner/plan_field.h"

namespace tramline {
namespace {

Field drawn(Ring outer) {
  Field out;
  out.id = "arms";
  out.outer = std::move(outer);
  return out;
}

Machine machine_of_12m() {
  Machine out;
  out.width_m = 12;
  out.radius_m = 6;
  return out;
}

PlanSettings as_by_default() {
  PlanSettings out;
  out.boundary = EdgeKind::kHard;
  out.turns = TurnPlanning::kRoute;
  out.aim = Aim::kWholeCost;
  out.shape = TrackShape::kAuto;
  out.headland_rule = out.obstacle_headland_rule = HeadlandRule::kTurns;
  return out;
}

Plan expect_whole_route_holds(const Field& field) {
  Plan plan = plan_field(field, machine_of_12m(), Objective{}, as_by_default(), 1);
  EXPECT_TRUE(plan.route.planned());
  for (const check::Violation& v : check::verify(plan).violations)
    ADD_FAILURE() << name(v.rule) << ": " << v.what;
  return plan;
}

// On the way between its passes the machine backs less far out of an arm than was found at first, and comes
// to the next pass another way: it has to back out of that along this way.
TEST(WholeRoutesInArms, BackAlongWhatWasDriven) {
  const Plan plan = expect_whole_route_holds(drawn({{0, 0},
                                                    {40, 0},
                                                    {40, 3},
                                                    {105, 9},
                                                    {105, 28},
                                                    {40, 30},
                                                    {40, 40},
                                                    {0, 40},
                                                    {0, 34},
                                                    {-66, 28},
                                                    {-61, 14},
                                                    {0, 8}}));
  EXPECT_GT(std::ranges::count(plan.route.legs, LegKind::kBackOut, &RouteLeg::kind), 0);
}

/// A block with an arm to the right, one up, and one to the left, one to three widths wide.
Field with_three_arms(std::mt19937_64& random) {
  const auto between = [&](double least, double most) {
    return std::uniform_real_distribution<double>(least, most)(random);
  };
  const double wide_m = between(40, 100), high_m = between(32, 60);
  const double right_m = between(11, 30), up_m = between(11, 30), left_m = between(11, 28);
  const double right_at_m = between(0, high_m - right_m), up_at_m = between(0, wide_m - up_m),
               left_at_m = between(0, high_m - left_m);
  const double to_right_m = wide_m + between(40, 90), to_top_m = high_m + between(40, 90),
               to_left_m = -between(40, 90);
  const auto off = [&](double x_m, double y_m) { return Point{x_m + between(-5, 5), y_m + between(-5, 5)}; };
  return drawn({{0, 0},
                {wide_m, 0},
                {wide_m, right_at_m},
                off(to_right_m, right_at_m),
                off(to_right_m, right_at_m + right_m),
                {wide_m, right_at_m + right_m},
                {wide_m, high_m},
                {up_at_m + up_m, high_m},
                off(up_at_m + up_m, to_top_m),
                off(up_at_m, to_top_m),
                {up_at_m, high_m},
                {0, high_m},
                {0, left_at_m + left_m},
                off(to_left_m, left_at_m + left_m),
                off(to_left_m, left_at_m),
                {0, left_at_m}});
}

TEST(WholeRoutesInArms, HoldOnRandomFields) {
  testing::for_each_seed(
      3, [](std::mt19937_64& random, int) { expect_whole_route_holds(with_three_arms(random)); });
}

}  // namespace
}  // namespace tramline
