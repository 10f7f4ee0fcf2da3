// Ways where the machine has no room: along the corridor between two rooms rather than straight across.

#include "tramline/route/connection/squeezed_way.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "tramline/route/axle/axle_path.h"

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

// A room of 60 m by 60 m, and an arm 6.6 m wide east of it, behind 10 m that are 0.2 m narrower than the bar.
Field room_with_an_arm() {
  Field field;
  field.id = "room with an arm";
  field.outer = {{0, 0},      {60, 0},    {60, 27.1}, {70, 27.1}, {70, 26.7}, {110, 26.7},
                 {110, 33.3}, {70, 33.3}, {70, 32.9}, {60, 32.9}, {60, 60},   {0, 60}};
  return field;
}

struct Scene {
  Field field;
  Machine machine{};
  Region tracks{};
  AllowedLand land{Region{{field.outer, {}}}};
  DrivingGround ground;
  RoadmapOnDemand roadmap;
  Connector connector;
  SteeredPath left = straight_on({20, 30.3}, 90, 20), entered = straight_on({116.7, 130}, 0, 20);

  Scene(const RoadmapFor& lines, Machine drives, Field on = rooms())
      : field(std::move(on)),
        machine(std::move(drives)),
        ground(land, field, machine, tracks),
        roadmap([this, lines] { return lines(ground); }, ground),
        connector(ground, roadmap, {}) {}
};

Machine six_metres_wide() {
  Machine out;
  out.width_m = kWidth_m;
  out.radius_m = kRadius_m;
  return out;
}

Roadmap no_lines(const DrivingGround&) { return {{}, 4}; }

/// A line along the middle of the corridor, from the one room into the other.
Roadmap through_the_corridor(const DrivingGround&) {
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

// No quarter turn has room in the arm: the machine can only come straight on, with at least 0.1 m of its bar
// beyond the neck on either side, and more where it is not yet in line with it.
TEST(SqueezedWays, LeadStraightIntoAnArm) {
  const auto into_the_arm = [](const DrivingGround&) {
    return Roadmap{{{straight_on({10, 30}, 90, 95)}}, 4};
  };
  Scene scene(into_the_arm, six_metres_wide(), room_with_an_arm());
  const SteeredPath left = straight_on({50, 2}, 0, 6), entered = straight_on({80, 30}, 90, 20);
  const Way straight = scene.connector.between(left, entered);
  ASSERT_GT(straight.missing_m, 3) << "across the corner between room and arm";
  SqueezedWays squeezed(scene.connector, scene.field, scene.tracks, into_the_arm);
  const Way way = squeezed.along_the_land(straight, left, entered);
  EXPECT_GE(way.missing_m, 0.1 - 0.002);
  EXPECT_LT(way.missing_m, 1);
  EXPECT_LT(distance(end_of(way.path).at, entered.front().start.at), 1e-6);
}

struct WayFromSpur {
  Way straight, squeezed;
  Point entered;
};

/// From work that leads west into a spur of the first room, which ends blind 40 m on and is so wide.
WayFromSpur way_from_a_spur(double wide_m) {
  constexpr double kMiddle_m = 30.3, kDeep_m = 40;
  const double low = kMiddle_m - 0.5 * wide_m, high = kMiddle_m + 0.5 * wide_m;
  Field field = rooms();
  field.outer.insert(field.outer.end(), {{0, high}, {-kDeep_m, high}, {-kDeep_m, low}, {0, low}});
  Scene scene(through_the_corridor, six_metres_wide(), field);
  const SteeredPath into_the_spur = straight_on({30, kMiddle_m}, 270, 65);
  const Way straight = scene.connector.between(into_the_spur, scene.entered);
  EXPECT_GT(straight.missing_m, 15) << "across the land of others";
  SqueezedWays squeezed(scene.connector, scene.field, scene.tracks, through_the_corridor);
  return {straight, squeezed.along_the_land(straight, into_the_spur, scene.entered),
          scene.entered.front().start.at};
}

// The machine comes out of the spur by the way it came. Through the corridor it sticks out by no more than it
// did.
TEST(SqueezedWays, BackOutOfASpurAndLeadOnAlongTheLand) {
  const auto [straight, way, entered] = way_from_a_spur(6.6);
  EXPECT_LT(way.missing_m, 3);
  ASSERT_TRUE(way.backs_out);
  const std::vector<RouteLeg> legs = legs_of(way);
  ASSERT_GE(legs.size(), 2U);
  EXPECT_EQ(legs.front().kind, LegKind::kBackOut);
  EXPECT_GE(length(legs.front().path), 35) << "to where there is room to turn";
  EXPECT_EQ(legs.front().missing_m, 0) << "along its work it has room";
  EXPECT_EQ(legs[1].missing_m, way.missing_m);
  EXPECT_LT(distance(end_of(way.path).at, entered), 1e-6);
}

// The machine would stick out while it backs, however narrow a machine backs out of the spur.
TEST(SqueezedWays, BackOutOfNoSpurThatIsTooNarrow) {
  const auto [straight, way, entered] = way_from_a_spur(5);
  EXPECT_FALSE(way.backs_on_land);
  EXPECT_EQ(length(way.path), length(straight.path));
  EXPECT_EQ(way.missing_m, straight.missing_m);
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

}  // namespace
}  // namespace tramline
