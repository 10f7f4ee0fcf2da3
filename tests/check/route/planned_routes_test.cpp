// Routes that the planner makes hold.

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "check/route/planned_routes.h"
#include "tramline/check/verify.h"

namespace tramline::planned_routes {
namespace {

TEST(PlannedRoutes, hold_on_a_rectangle) {
  for (const int headlands : {0, 1, 2}) {
    SCOPED_TRACE(headlands);
    expect_route_holds(field_of(box(0, 0, 200, 100)), machine(6, 6), whole_route(headlands));
  }
}

TEST(PlannedRoutes, hold_on_an_l_with_a_pond) {
  const Field field = with(l_shape(), box(60, 60, 90, 85), ObstacleKind::kObstacle);
  for (const bool first : {false, true}) {
    PlanSettings settings = whole_route(2);
    settings.route.passes = first ? PassTime::kFirst : PassTime::kLast;
    expect_route_holds(field, machine(6, 5), settings);
  }
}

/// The first leg along a pass round an obstacle.
std::size_t leg_round_obstacle(const Plan& plan) {
  const auto found = std::ranges::find_if(plan.route.legs, [&](const RouteLeg& leg) {
    return leg.pass && !plan.headland.passes[*leg.pass].obstacles.empty();
  });
  return static_cast<std::size_t>(found - plan.route.legs.begin());
}

/// The same plan, with a leg driven before all others.
Plan with_first(Plan plan, std::size_t leg) {
  const auto at = plan.route.legs.begin() + static_cast<std::ptrdiff_t>(leg);
  std::rotate(plan.route.legs.begin(), at, at + 1);
  return plan;
}

bool finds(const Plan& plan, const std::string& what) {
  const check::Verdict verdict = check::verify(plan);
  return std::ranges::any_of(verdict.violations, [&](const check::Violation& v) {
    return v.rule == check::Rule::kRouteOrder && v.what.find(what) != std::string::npos;
  });
}

// Of two ponds at opposite sides of a field the route can end its tracks at one only. The pass round the
// other it works on its way, once the tracks that end there are done.
TEST(PlannedRoutes, work_the_pass_round_a_pond_among_the_tracks) {
  const Field field = with(with(field_of(box(0, 0, 300, 200)), box(60, 50, 90, 80), ObstacleKind::kObstacle),
                           box(220, 120, 250, 150), ObstacleKind::kObstacle);
  PlanSettings settings = whole_route(2);
  settings.obstacle_headlands = 1;
  settings.avoid = Avoidance::kCut;
  const Plan plan = expect_route_holds(field, machine(6, 6), settings);
  const std::size_t round = leg_round_obstacle(plan);
  const auto& legs = plan.route.legs;
  ASSERT_LT(round, legs.size());
  const auto is_track = [](const RouteLeg& leg) { return leg.piece.has_value(); };
  EXPECT_TRUE(std::any_of(legs.begin() + static_cast<std::ptrdiff_t>(round), legs.end(), is_track));
  EXPECT_FALSE(finds(plan, "works a track"));
  EXPECT_TRUE(finds(with_first(plan, round), "works a track that ends beside headland pass"));
  EXPECT_TRUE(finds(with_first(plan, legs.size() - 1), "works a track after the passes"));
}

TEST(PlannedRoutes, hold_across_a_ditch) {
  const Field field = with(field_of(box(0, 0, 200, 100)), box(90, -5, 95, 105), ObstacleKind::kPassable);
  Field clipped = field;
  clipped.obstacles[0].shape.outer = box(90, 0, 95, 100);
  expect_route_holds(clipped, machine(6, 6), whole_route(2));
}

TEST(PlannedRoutes, hold_between_gates) {
  PlanSettings settings = whole_route(2);
  settings.route.start = Point{0, 40};
  settings.route.end = Point{150, 50};
  expect_route_holds(field_of(box(0, 0, 200, 100)), machine(6, 6), settings);
}

}  // namespace
}  // namespace tramline::planned_routes
