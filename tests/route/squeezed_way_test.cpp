// Ways where the machine has no room: along the corridor between two rooms rather than straight across, and
// told of as they are driven.

#include "tramline/route/connection/squeezed_way.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace tramline {
namespace {

constexpr double kRadius_m = 6, kWidth_m = 6;

SteeredPath straight_on(Point at, double clockwise_from_north, double length_m) {
  const Pose from{at, Heading::clockwise_from_north(Angle::degrees(clockwise_from_north))};
  return {arc_from(from, length_m, 0, Gear::kForward)};
}

// Two rooms of 60 m by 60 m. A corridor 6.6 m wide leads east from the one, at x = 113.4 to 120 m it turns
// north, and ends in the other.
Field rooms() {
  Field field;
  field.id = "rooms";
  field.outer = {{0, 0},    {60, 0},   {60, 27},     {120, 27},     {120, 120}, {150, 120}, {150, 180},
                 {90, 180}, {90, 120}, {113.4, 120}, {113.4, 33.6}, {60, 33.6}, {60, 60},   {0, 60}};
  return field;
}

struct Scene {
  Field field = rooms();
  Machine machine{};
  Region tracks{};
  AllowedLand land{Region{{field.outer, {}}}};
  DrivingGround ground;
  RoadmapOnDemand roadmap;
  Connector connector;
  SteeredPath left = straight_on({20, 30.3}, 90, 20), entered = straight_on({116.7, 130}, 0, 20);

  Scene(const std::function<Roadmap()>& lines, Machine drives)
      : machine(std::move(drives)),
        ground(land, field, machine, tracks),
        roadmap(lines, ground),
        connector(ground, roadmap, {}) {}
};

Machine six_metres_wide() {
  Machine out;
  out.width_m = kWidth_m;
  out.radius_m = kRadius_m;
  return out;
}

Roadmap no_lines() { return {{}, 4}; }

/// A line along the middle of the corridor, from the one room into the other.
Roadmap through_the_corridor() {
  SteeredPath line = straight_on({45, 30.3}, 90, 116.7 - kRadius_m - 45);
  line.push_back(arc_from(end_of(line), 0.5 * std::numbers::pi * kRadius_m, 1 / kRadius_m, Gear::kForward));
  line.push_back(arc_from(end_of(line), 130 - 30.3 - kRadius_m, 0, Gear::kForward));
  return {{{line}}, 4};
}

// The axle turns about a place 2.7 m, its radius less half the corridor, west of the inner corner and as much
// north of it. Half-way round the bar points at the corner and ends 3 m from that place, 2.7 m √2 - 3 m
// beyond the corner: both sides of the corridor are nearer to it by √2.
TEST(SqueezedWays, LeaveTheLandInTheBendOfACorridorAlone) {
  Scene scene(through_the_corridor, six_metres_wide());
  const Way straight = scene.connector.between(scene.left, scene.entered);
  ASSERT_GT(straight.missing_m, 15) << "across the land of others";
  SqueezedWays squeezed(scene.connector, scene.field, scene.tracks, through_the_corridor);
  const Way way = squeezed.along_the_land(straight, scene.left, scene.entered);
  const double beyond_corner_m = 2.7 * std::numbers::sqrt2 - 0.5 * kWidth_m;
  EXPECT_NEAR(way.missing_m, beyond_corner_m / std::numbers::sqrt2, 0.002);
  EXPECT_GT(length(way.path), length(straight.path));
  EXPECT_TRUE(
      std::ranges::all_of(way.path, [](const SteeredStretch& s) { return s.gear == Gear::kForward; }));
  EXPECT_LT(distance(way.path.front().start.at, end_of(scene.left).at), 1e-6);
  EXPECT_LT(distance(end_of(way.path).at, scene.entered.front().start.at), 1e-6);
  EXPECT_NEAR(way.time_s, idle_seconds(way.path, scene.machine.turning), 1e-9);
}

TEST(SqueezedWays, AreWhatTheyWereWhereNoLineLeadsThere) {
  Scene scene(no_lines, six_metres_wide());
  const Way straight = scene.connector.between(scene.left, scene.entered);
  SqueezedWays squeezed(scene.connector, scene.field, scene.tracks, no_lines);
  const Way way = squeezed.along_the_land(straight, scene.left, scene.entered);
  EXPECT_EQ(length(way.path), length(straight.path));
  EXPECT_EQ(way.missing_m, straight.missing_m);
}

TEST(SqueezedWays, AreWhatTheyWereWithADrawbar) {
  Machine towing = six_metres_wide();
  towing.turning.implement = Coupling::kTowed;
  towing.turning.drawbar_m = 4;
  Scene scene(through_the_corridor, towing);
  const Way straight = scene.connector.between(scene.left, scene.entered);
  ASSERT_FALSE(straight.has_room());
  SqueezedWays squeezed(scene.connector, scene.field, scene.tracks, through_the_corridor);
  const Way way = squeezed.along_the_land(straight, scene.left, scene.entered);
  EXPECT_EQ(length(way.path), length(straight.path));
  EXPECT_EQ(way.missing_m, straight.missing_m);
}

constexpr double kTight_m = 1, kDrawbar_m = 2.66, kLift_m = 2.2, kLower_m = 0.5;

/// Six metres wide, behind a drawbar that is longer than the radius.
Machine towing() {
  Machine out;
  out.width_m = kWidth_m;
  out.radius_m = kTight_m;
  out.turning.implement = Coupling::kTowed;
  out.turning.drawbar_m = kDrawbar_m;
  out.turning.lift_m = kLift_m;
  out.turning.lower_m = kLower_m;
  return out;
}

/// How far the implement is beside its line behind half a circle and so much straight on, m. The angle b from
/// the drawbar to the machine's heading grows by 1/r of the way, and falls by sin b / L of it; by the
/// midpoint of each of many steps.
double beside_m(double straight_m) {
  double b = 0;
  const auto drive = [&b](double way_m, double curvature) {
    constexpr int kSteps = 20000;
    const double step_m = way_m / kSteps;
    const auto rate = [&](double angle) { return curvature - std::sin(angle) / kDrawbar_m; };
    for (int i = 0; i < kSteps; ++i) b += step_m * rate(b + 0.5 * step_m * rate(b));
  };
  drive(std::numbers::pi * kTight_m, 1 / kTight_m);
  drive(straight_m, 0);
  return kDrawbar_m * std::abs(std::sin(b));
}

// On land four metres wide. Half a circle bends the drawbar by more than a right angle, so that the implement
// is farther beside the line behind the straight on which it is lowered than before.
TEST(WaysWithoutRoom, TellWhereTheImplementIsWhenItIsLowered) {
  Field field;
  field.outer = {{-3, 0}, {1, 0}, {1, 80}, {-3, 80}};
  const AllowedLand land{Region{{field.outer, {}}}};
  const Region tracks;
  const Machine machine = towing();
  const DrivingGround ground(land, field, machine, tracks);
  RoadmapOnDemand roadmap([] { return Roadmap({}, 4); }, ground);
  const Connector connector(ground, roadmap, {});
  // The circle begins where the implement is lifted, and ends where it is still to be lowered.
  const SteeredPath left = straight_on({0, 20}, 0, 30),
                    entered = straight_on({-2 * kTight_m, 50 + kLift_m - kLower_m}, 180, 30);
  const Way way = connector.between(left, entered);
  ASSERT_FALSE(way.has_room());
  EXPECT_NEAR(length(way.path), kLift_m + std::numbers::pi * kTight_m + kLower_m, 1e-9);
  ASSERT_GT(beside_m(kLower_m), beside_m(0) + 0.05);
  EXPECT_NEAR(way.lateral_error_m, beside_m(kLower_m), 1e-6);
  EXPECT_NEAR(way.time_s, length(way.path) / machine.turning.turning_speed_mps, 1e-9);
}

}  // namespace
}  // namespace tramline
