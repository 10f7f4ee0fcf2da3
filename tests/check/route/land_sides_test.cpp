// What stops the verifier asks for between lines and closed passes.

#include "tramline/check/rules/route/land_sides.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "check/plans.h"
#include "tramline/check/rules/route/route_facts.h"

namespace tramline::check {
namespace {

constexpr double kStop_s = 100;

/// 100 m by 200 m, a machine of 6 m that turns by 6 m, and a route that has backed once.
Plan plan_with_a_stop() {
  Plan out;
  out.field.outer = {{0, 0}, {100, 0}, {100, 200}, {0, 200}};
  out.machine.width_m = out.machine.radius_m = 6;
  out.settings.boundary = EdgeKind::kHard;
  out.route.proof.stop_s = kStop_s;
  RouteLeg leg;
  leg.kind = LegKind::kBackOut;
  out.route.legs.push_back(leg);
  return out;
}

double at_once(const Pose&) { return 0; }

/// North to a place from 150 m before it.
WorkedCourse north_to(Point at, const Plan& plan) {
  return {{{at - Point{0, 150}, at, 0}}, PathEnds::kApart, plan.machine};
}

/// Round a rectangle, either way.
std::vector<LineStep> steps_round(const Path& pass, const LandSides& sides, const Plan& plan) {
  std::vector<LineStep> out;
  for (const Path& path : {pass, reversed(pass)}) {
    const std::vector<LineStep> steps = sides.round({path, PathEnds::kMeet, plan.machine});
    out.insert(out.end(), steps.begin(), steps.end());
  }
  return out;
}

// To turn aside takes r + w/2 = 9 m to the edge ahead. From 8 m no way leads to the pass along the edge
// without a stop, nor one back from there; from 12 m one does. A pass that goes on where the track ends needs
// none at either place.
TEST(LandSides, AskForAStopWhereNoWayForwardLeadsToAClosedPass) {
  const Plan plan = plan_with_a_stop();
  const std::optional<LandSides> sides = LandSides::of(plan);
  ASSERT_TRUE(sides);
  const std::vector<LineStep> edge = steps_round(testing_plans::rounded_rectangle(3, 3, 97, 197, 6), *sides,
                                                 plan),
                              ahead = steps_round(testing_plans::rounded_rectangle(40, 20, 80, 197, 6),
                                                  *sides, plan);
  const double stop_s = kStop_s + 2 * plan.machine.turning.gear_change_s;
  for (const double at_m : {192.0, 188.0}) {
    const WorkedCourse track = north_to({40, at_m}, plan);
    const WorkedCourse back({{{40, at_m}, {40, at_m - 150}, 0}}, PathEnds::kApart, plan.machine);
    const double asked_s = at_m > 191 ? stop_s : 0;
    EXPECT_NEAR(sides->with_stop_s(sides->leaving(track), edge, at_once), asked_s, 0.02);
    EXPECT_NEAR(sides->with_stop_s(sides->entering(back), edge, at_once), asked_s, 0.02);
  }
  // It backs out 1 m, and a quarter of a circle of 6 m leads to the pass at y = 197.
  const Turning& turning = plan.machine.turning;
  const auto on_s = [&](const Pose& from) {
    const double to_line_m = 197 - from.at.y;
    const double arc_m = 0.5 * std::numbers::pi * 6;
    return (to_line_m < 6 ? 1000 : arc_m + to_line_m - 6) / turning.turning_speed_mps;
  };
  const double backed_s =
      stop_s + 1 / turning.reverse_speed_mps + 3 * std::numbers::pi / turning.turning_speed_mps;
  EXPECT_NEAR(sides->with_stop_s(sides->leaving(north_to({40, 192}, plan)), edge, on_s), backed_s, 0.05);
  const WorkedCourse track = north_to({40, 189}, plan);
  EXPECT_EQ(sides->with_stop_s(sides->leaving(track), ahead, at_once), 0);
}

// Two tracks at 45° to an edge 9 m ahead, 8.49 m apart: between them is a loop of 270°, and √(8.49² + 12²) m
// besides. A track of two pieces, the second of which is turned by a hundred-millionth, is straight as well.
TEST(LandSides, AskForALoopOfTracksThatRoundingBends) {
  Plan plan = plan_with_a_stop();
  plan.field.outer = {{0, 0}, {400, 0}, {400, 200}, {0, 200}};
  plan.route.proof.stop_s = 0;
  plan.machine.turning.turning_speed_mps = 1.5;
  plan.machine.turning.reverse_speed_mps = 1;
  plan.machine.turning.gear_change_s = 10;  // or it would back
  const std::optional<LandSides> sides = LandSides::of(plan);
  ASSERT_TRUE(sides);
  const double apart_m = 6 * std::numbers::sqrt2, along_m = 60 / std::numbers::sqrt2;
  const Point off{200, 191}, back{200 - apart_m, 191}, along{along_m, along_m};
  const WorkedCourse entered({{back, back - along, 0}}, PathEnds::kApart, plan.machine);
  const double loop_s = (1.5 * std::numbers::pi * 6 + std::hypot(apart_m, 12)) / 1.5;
  for (const double aside_m : {0.0, 3e-7, -3e-7}) {
    const Point middle = off - 0.5 * along + Point{aside_m, -aside_m};
    const WorkedCourse left({{off - along, middle, 0}, {middle, off, 0}}, PathEnds::kApart, plan.machine);
    EXPECT_NEAR(sides->least_s(sides->leaving(left), sides->entering(entered), 0, kNever_s), loop_s, 0.3);
  }
}

// A strip of 16 m, on which it cannot turn round: 10 m aside takes it √(10 · (4 · 6 − 10)) = 11.8 m on. A
// track that begins 6 m farther on than the other ends, driven the same way, is reached once it has
// backed 5.8 m.
TEST(LandSides, AskForAStopAndTheWayBackWhereNoWayLeadsForward) {
  Plan plan = plan_with_a_stop();
  plan.field.outer = {{0, 0}, {16, 0}, {16, 200}, {0, 200}};
  plan.machine.turning.turning_speed_mps = plan.machine.turning.reverse_speed_mps = 3;
  const double aside_s = 2 * 6 * std::acos(1 - 10.0 / 12) / 3, backed_s = (std::sqrt(140) - 6) / 3;
  const double gears_s = 2 * plan.machine.turning.gear_change_s;
  const WorkedCourse left({{{3, 40}, {3, 100}, 0}}, PathEnds::kApart, plan.machine),
      entered({{{13, 106}, {13, 166}, 0}}, PathEnds::kApart, plan.machine);
  const auto least_s = [&] {
    const LandSides sides = LandSides::of(plan).value();
    return sides.least_s(sides.leaving(left), sides.entering(entered), 0, kNever_s);
  };
  EXPECT_LE(least_s(), kStop_s + gears_s + backed_s + aside_s);
  EXPECT_GE(least_s(), kStop_s + gears_s + backed_s + aside_s - 0.5);
  plan.route.legs.front().kind = LegKind::kTransit;
  EXPECT_LT(least_s(), kStop_s);
}

// Nothing is known where a route never stops.
TEST(LandSides, AskForNoStopOfRoutesWithoutAny) {
  Plan plan = plan_with_a_stop();
  plan.route.legs.front().kind = LegKind::kTransit;
  const std::optional<LandSides> sides = LandSides::of(plan);
  ASSERT_TRUE(sides);
  const std::vector<LineStep> edge =
      steps_round(testing_plans::rounded_rectangle(3, 3, 97, 197, 6), *sides, plan);
  EXPECT_EQ(sides->with_stop_s(sides->leaving(north_to({40, 192}, plan)), edge, at_once), 0);
}

}  // namespace
}  // namespace tramline::check
