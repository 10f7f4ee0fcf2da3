// Whole routes that start and end at gates.

#include <gtest/gtest.h>

#include "planner/route/sound_route.h"
#include "tramline/planner/plan_field.h"

namespace tramline {
namespace {

using testing::end_of;
using testing::expect_on_the_land;
using testing::expect_sound;
using testing::rectangle;
using testing::whole_route;

TEST(RouteGates, StartsAndEndsAtGates) {
  PlanSettings settings = whole_route(3);
  settings.route.start = Point{20, 20};
  settings.route.end = Point{280, 20};
  const Plan plan = plan_field(rectangle(300, 150), {"", 6, 5}, {}, settings);
  expect_sound(plan);
  expect_on_the_land(plan);
  EXPECT_LT(distance(plan.route.legs.front().path.front().start.at, {20, 20}), 1e-6);
  EXPECT_LT(distance(end_of(plan.route.legs.back()).at, {280, 20}), 1e-6);
  EXPECT_EQ(plan.route.legs.front().kind, LegKind::kTransit);
}

// A machine with a bar of 6 m has no room at a gate on the edge: the route begins as near as it has.
TEST(RouteGates, BeginsBesideAGateOnTheEdge) {
  PlanSettings settings = whole_route(3);
  settings.route.start = Point{150, 0};
  const Plan plan = plan_field(rectangle(300, 150), {"", 6, 5}, {}, settings);
  ASSERT_TRUE(plan.settings.route.start);
  const Point start = plan.route.legs.front().path.front().start.at;
  EXPECT_EQ(start, *plan.settings.route.start);
  EXPECT_LE(distance(start, {150, 0}), 4);
  expect_on_the_land(plan);
}

// Between its edges no machine of 3 m turns on land 4 m wide: from a gate beside the middle of its only track
// it backs to where the track begins, and back to the gate from where it ends.
TEST(RouteGates, BacksFromAGateToTheBeginningOfATrack) {
  for (const bool reverse : {false, true}) {
    PlanSettings settings = whole_route(0);
    settings.boundary = EdgeKind::kHard;
    settings.route.start = settings.route.end = Point{2, 30};
    Machine machine{"", 3, 6};
    machine.turning.reverse = reverse;
    const Plan plan = plan_field(rectangle(4, 60), machine, {}, settings);
    expect_sound(plan);
    expect_on_the_land(plan);
    const RouteSums sums = sums_of(plan.route);  // half of the track before it is worked, and half afterwards
    EXPECT_NEAR(sums.reverse_m, 60, 4);
    EXPECT_NEAR(sums.not_working_m(), 60, 8);
  }
}

}  // namespace
}  // namespace tramline
