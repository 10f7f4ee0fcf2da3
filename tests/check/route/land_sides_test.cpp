// What stops the verifier asks for between lines and closed passes.

#include "tramline/check/rules/route/land_sides.h"

#include <gtest/gtest.h>

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
    EXPECT_DOUBLE_EQ(sides->stops_s(sides->leaving(track), edge), asked_s);
    EXPECT_DOUBLE_EQ(sides->stops_s(sides->entering(back), edge), asked_s);
  }
  const WorkedCourse track = north_to({40, 189}, plan);
  EXPECT_EQ(sides->stops_s(sides->leaving(track), ahead), 0);
}

// Nothing is known where a route never stops.
TEST(LandSides, AskForNoStopOfRoutesWithoutAny) {
  Plan plan = plan_with_a_stop();
  plan.route.legs.front().kind = LegKind::kTransit;
  const std::optional<LandSides> sides = LandSides::of(plan);
  ASSERT_TRUE(sides);
  const std::vector<LineStep> edge =
      steps_round(testing_plans::rounded_rectangle(3, 3, 97, 197, 6), *sides, plan);
  EXPECT_EQ(sides->stops_s(sides->leaving(north_to({40, 192}, plan)), edge), 0);
}

}  // namespace
}  // namespace tramline::check
