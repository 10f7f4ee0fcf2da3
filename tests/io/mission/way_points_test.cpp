// Routes as points: on the way, near enough to it, and with what belongs to the way to each.

#include "tramline/io/mission/way_points.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "io/mission/small_route.h"
#include "tramline/io/mission/geofence.h"
#include "tramline/io/mission/mission_items.h"

namespace tramline::io::way_points_test {

using testing_mission::plan_with_route;

TEST(WayPoints, ChordsStayWithinTheToleranceOfTheWay) {
  const Plan plan = plan_with_route();
  for (const double tolerance_m : {0.001, 0.02, 0.2}) {
    const std::vector<WayPoint> points = way_points(plan, tolerance_m);
    EXPECT_EQ(points.front().at, (Point{0, 1.5}));
    EXPECT_NEAR(distance(points.back().at, {5, 4.5}), 0, 1e-9);
    for (const WayPoint& point : points) {
      // Half a circle of 1.5 m round (100, 3), the two tracks, and 5 m back along the second.
      const double off = point.at.x > 100 ? std::abs(distance(point.at, {100, 3}) - 1.5)
                                          : std::min(std::abs(point.at.y - 1.5), std::abs(point.at.y - 4.5));
      EXPECT_NEAR(off, 0, 1e-9);
    }
    for (std::size_t i = 0; i + 1 < points.size(); ++i) {
      const Point middle = midpoint(points[i].at, points[i + 1].at);
      if (middle.x > 100) {
        EXPECT_LE(1.5 - distance(middle, {100, 3}), tolerance_m);
      }
    }
  }
  EXPECT_GT(way_points(plan, 0.001).size(), way_points(plan, 0.2).size());
}

TEST(WayPoints, EachSaysHowTheWayToItIsDriven) {
  const std::vector<WayPoint> points = way_points(plan_with_route(), 0.02);
  EXPECT_NEAR(distance(points[1].at, {100, 1.5}), 0, 1e-9);
  EXPECT_TRUE(points[1].work);
  EXPECT_EQ(points[1].speed_mps, 2.5);
  EXPECT_FALSE(points[2].work);
  EXPECT_EQ(points[2].speed_mps, 1.5);
  EXPECT_EQ(points.back().gear, Gear::kReverse);
  EXPECT_EQ(points.back().speed_mps, 1);
  EXPECT_NEAR(points.back().heading.degrees(), 270, 1e-9) << "in reverse the machine points as before";
}

std::vector<int> commands_of(const Mission& mission) {
  std::vector<int> out;
  for (const MissionItem& item : mission.items)
    if (out.empty() || item.command != mavlink::kWaypoint || out.back() != mavlink::kWaypoint)
      out.push_back(item.command);
  return out;
}

TEST(MissionItems, WorkSpeedAndGearAreSwitchedWhereTheyChange) {
  const Plan plan = plan_with_route();
  EXPECT_EQ(commands_of(mission_of(plan, std::nullopt, 0.02)),
            (std::vector<int>{178, 16, 216, 16, 216, 178, 16, 216, 178, 16, 216, 194, 178, 16}));
  const Flight flight{3, 5, Landing::kHome, 7};
  const Mission flown = mission_of(plan, flight, 0.02);
  EXPECT_EQ(commands_of(flown),
            (std::vector<int>{22, 178, 16, 183, 16, 183, 178, 16, 183, 178, 16, 183, 178, 16, 20}));
  EXPECT_EQ(flown.items[0].params[6], 5);
  // Speeds of small_plan()'s machine: at work, turning, at work, and back out of the track.
  const Turning& turning = plan.machine.turning;
  std::vector<double> speeds, gears;
  for (const MissionItem& item : mission_of(plan, std::nullopt, 0.02).items) {
    if (item.command == 178) speeds.push_back(item.params[1].value());
    if (item.command == 194) gears.push_back(item.params[0].value());
  }
  EXPECT_EQ(speeds, (std::vector<double>{turning.working_speed_mps, turning.turning_speed_mps,
                                         turning.working_speed_mps, turning.reverse_speed_mps}));
  EXPECT_EQ(gears, (std::vector<double>{1}));
  const auto servo = std::find_if(flown.items.begin(), flown.items.end(),
                                  [](const MissionItem& item) { return item.command == mavlink::kSetServo; });
  EXPECT_EQ(servo->params[0], 7);
  EXPECT_EQ(servo->params[1], 1900);
}

TEST(MissionItems, TooManyAreRefused) {
  Plan plan = plan_with_route();
  const auto legs = plan.route.legs;
  while (plan.route.legs.size() < 90000)
    plan.route.legs.insert(plan.route.legs.end(), legs.begin(), legs.end());
  EXPECT_REFUSED(mission_of(plan, std::nullopt, 0.02));
}

TEST(Geofence, StandsWhereTheRouteDoesNotPass) {
  Plan plan = plan_with_route();
  const std::vector<WayPoint> route = way_points(plan, 0.02);
  // The turn is outside the field of 100 m by 6 m.
  const Geofence outside = geofence_of(plan, route);
  EXPECT_TRUE(outside.stay_inside.empty());
  ASSERT_EQ(outside.notes.size(), 1U);
  plan.field.outer = {{-1, 0}, {102, 0}, {102, 6}, {-1, 6}};
  plan.field.obstacles = {
      {{{{40, 2.5}, {42, 2.5}, {42, 3.5}}, {}}, ObstacleKind::kObstacle, "hole 1"},
      {{{{50, 1}, {52, 1}, {52, 5}}, {}}, ObstacleKind::kPassable, "hole 2"},
      {{{{100.5, 2}, {101.9, 2}, {101.9, 4}, {100.5, 4}}, {}}, ObstacleKind::kObstacle, "hole 3"}};
  const Geofence inside = geofence_of(plan, route);
  EXPECT_EQ(inside.stay_inside.size(), 1U);
  EXPECT_EQ(inside.stay_outside, (std::vector<Ring>{plan.field.obstacles[0].shape.outer}));
  ASSERT_EQ(inside.notes.size(), 1U);
  EXPECT_TRUE(testing_support::mentions(inside.notes[0], "obstacle 3"));
}

// The first track is one straight stretch at y = 1.5 m, with points at its ends only.
TEST(Geofence, FallsWhereTheRoutePassesBetweenItsPoints) {
  Plan plan = plan_with_route();
  const std::vector<WayPoint> route = way_points(plan, 0.02);
  plan.field.outer = {{-1, 0}, {60, 0}, {61, 2}, {62, 0}, {102, 0}, {102, 6}, {-1, 6}};
  plan.field.obstacles = {{{{{50, 1}, {52, 1}, {52, 2}}, {}}, ObstacleKind::kObstacle, "hole 1"}};
  const Geofence fence = geofence_of(plan, route);
  EXPECT_TRUE(fence.stay_inside.empty());
  EXPECT_TRUE(fence.stay_outside.empty());
  EXPECT_EQ(fence.notes.size(), 2U);
}

}  // namespace tramline::io::way_points_test
