// Ways off the end of a track, by hand: a quarter turn of radius r needs the land r + w/2 deep.

#include "tramline/turns/turn_off.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace tramline {
namespace {

const Heading kDueNorth = Heading::clockwise_from_north(Angle::degrees(0));

/// Land from 100 m south of the track's end to `depth_m` north of it, and 50 m to either side.
AllowedLand land_before(double depth_m) {
  return AllowedLand({{{{-50, -100}, {50, -100}, {50, depth_m}, {-50, depth_m}}, {}}});
}

Machine bar(double width_m, double radius_m) {
  Machine out;
  out.width_m = width_m;
  out.radius_m = radius_m;
  return out;
}

TEST(TurnOff, ABarNeedsItsRadiusAndHalfItsWidth) {
  EXPECT_TRUE(has_way_off(land_before(7.5), {0, 0}, kDueNorth, bar(3, 6)));
  EXPECT_FALSE(has_way_off(land_before(7.49), {0, 0}, kDueNorth, bar(3, 6)));
}

TEST(TurnOff, LiftingTakesRoomToo) {
  Machine machine = bar(3, 6);
  machine.turning.lift_m = 2;
  EXPECT_TRUE(has_way_off(land_before(9.5), {0, 0}, kDueNorth, machine));
  EXPECT_FALSE(has_way_off(land_before(9.49), {0, 0}, kDueNorth, machine));
}

// The bar is l behind the axle, so the axle is l ahead when the work ends. Its outer end is on a circle of
// √((r + w/2)² + l²) about a point l ahead of the end: 2 + √(7.5² + 2²) at the farthest.
TEST(TurnOff, AMountedImplementSwingsOut) {
  Machine machine = bar(3, 6);
  machine.turning.implement_offset_m = 2;
  // its outer end is farthest ahead when it is ahead of the centre: before the quarter turn is complete it
  // gets there where the radius points ahead, atan(l/(r + w/2)) short of it
  const double depth_m = 2 + std::hypot(7.5, 2);
  EXPECT_FALSE(has_way_off(land_before(9.49), {0, 0}, kDueNorth, machine));
  EXPECT_TRUE(has_way_off(land_before(depth_m + 1e-6), {0, 0}, kDueNorth, machine));
}

// A wall on the left: off to the right. Walls on both sides, half a width off: no way off, however deep.
TEST(TurnOff, OneSideIsEnough) {
  const AllowedLand left_is_walled({{{{-1.5, -100}, {50, -100}, {50, 10}, {-1.5, 10}}, {}}});
  EXPECT_TRUE(has_way_off(left_is_walled, {0, 0}, kDueNorth, bar(3, 6)));
  const AllowedLand alley({{{{-1.5, -100}, {1.5, -100}, {1.5, 90}, {-1.5, 90}}, {}}});
  EXPECT_FALSE(has_way_off(alley, {0, 0}, kDueNorth, bar(3, 6)));
}

// 12 m of steering on a turn of 9.42 m: two clothoids make it, and it is deeper than the quarter circle.
TEST(TurnOff, SteeringTakesRoom) {
  Machine machine = bar(3, 6);
  machine.turning.turning_speed_mps = 1.5;
  machine.turning.steering_time_s = 2;
  EXPECT_FALSE(has_way_off(land_before(7.6), {0, 0}, kDueNorth, machine));
  EXPECT_TRUE(has_way_off(land_before(12), {0, 0}, kDueNorth, machine));
  for (const SteeredPath& way : ways_off_end({0, 0}, kDueNorth, machine)) {
    const double turned = end_of(way.back()).heading.degrees();
    EXPECT_TRUE(std::abs(turned - 90) < 1e-9 || std::abs(turned - 270) < 1e-9) << turned;
  }
}

TEST(TurnOff, AVerySlowSteererNeverReachesItsSmallestCircle) {
  Machine machine = bar(3, 6);
  machine.turning.steering_time_s = 20;
  for (const SteeredPath& way : ways_off_end({0, 0}, kDueNorth, machine)) {
    double tightest = 0;
    for (const SteeredStretch& stretch : way)
      tightest =
          std::max({tightest, std::abs(stretch.curvature_at_start), std::abs(stretch.curvature_at_end)});
    EXPECT_LT(tightest, 1.0 / 6);
    const double turned = end_of(way.back()).heading.degrees();
    EXPECT_TRUE(std::abs(turned - 90) < 1e-9 || std::abs(turned - 270) < 1e-9) << turned;
  }
}

}  // namespace
}  // namespace tramline
