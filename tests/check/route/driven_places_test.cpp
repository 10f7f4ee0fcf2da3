// Where the verifier finds that machines get on convex land, against ways driven at random and the planner.

#include "tramline/check/rules/route/driven_places.h"

#include <gtest/gtest.h>

#include <iostream>

#include "properties/random_drive.h"
#include "properties/seeds.h"
#include "tramline/route/backing/heading_reach.h"

namespace tramline::check {
namespace {

using tramline::testing::DriveScene;
using tramline::testing::for_each_seed;

ConvexLand land_of(const DriveScene& scene) {
  std::vector<ConvexLand::Edge> edges;
  for (std::size_t i = 0; i < scene.land.size(); ++i) {
    const Point edge = scene.land[(i + 1) % scene.land.size()] - scene.land[i];
    edges.push_back({scene.land[i], 1 / std::hypot(edge.x, edge.y) * Point{-edge.y, edge.x}});
  }
  return {std::move(edges), scene.corners(), scene.machine.radius_m};
}

bool may_point(const DrivenPlaces& places, const Pose& pose) { return may_be_on({{pose, pose}}, places); }

Pose place(Point at, double clockwise_from_north) {
  return {at, Heading::clockwise_from_north(Angle::degrees(clockwise_from_north))};
}

// Half a turn of 6 m and the halves of a bar of 12 m take 24 m across a strip. On 21 m the machine turns by a
// right angle, gets aside, and on, but not round, nor back to where it was.
TEST(DrivenPlaces, TurnRoundWhereTheStripIsWideEnough) {
  DriveScene scene{{}, {}, place({6, 60}, 0)};
  scene.machine.width_m = 12;
  scene.machine.radius_m = 6;
  scene.land = {{0, 0}, {24.1, 0}, {24.1, 200}, {0, 200}};
  EXPECT_TRUE(may_point(land_of(scene).driven_from(scene.from, 1), place({18, 60}, 180)));
  scene.land = {{0, 0}, {21, 0}, {21, 200}, {0, 200}};
  const ConvexLand strip = land_of(scene);
  const DrivenPlaces ahead = strip.driven_from(scene.from, 1);
  EXPECT_FALSE(may_point(ahead, place({15, 60}, 180)));
  EXPECT_TRUE(may_point(ahead, place({12, 66}, 90)));
  EXPECT_TRUE(may_point(ahead, place({14, 150}, 0)));
  EXPECT_FALSE(may_point(ahead, place({6, 50}, 0)));
  // What leads to a place forward lies where the machine backs to from there.
  EXPECT_TRUE(may_be_common(ahead, strip.driven_from(place({14, 150}, 0), -1)));
  EXPECT_FALSE(may_be_common(ahead, strip.driven_from(place({6, 50}, 0), -1)));
}

// All that is driven is held, and what the planner rules out the verifier rules out: bounds are proven by it.
TEST(DrivenPlaces, HoldWhatIsDrivenAndNoMoreThanThePlannerThinks) {
  int driven = 0, ruled_out = 0;
  for_each_seed(200, [&](std::mt19937_64& random, int) {
    const auto scene = tramline::testing::random_drive_scene(random);
    if (!scene) return;
    const double sense = scene->gear == Gear::kForward ? 1 : -1;
    const ConvexLand land = land_of(*scene);
    const DrivenPlaces places = land.driven_from(scene->from, sense);
    for (int i = 0; i < 20; ++i)
      for (const SteeredStretch& stretch : tramline::testing::driven_at_random(*scene, random)) {
        ++driven;
        EXPECT_TRUE(may_point(places, end_of(stretch)));
      }
    std::vector<HeadingReach::Side> sides;
    for (std::size_t i = 0; i < scene->land.size(); ++i) {
      const Point edge = scene->land[(i + 1) % scene->land.size()] - scene->land[i];
      sides.push_back({scene->land[i], left_of(1 / std::hypot(edge.x, edge.y) * edge)});
    }
    const HeadingReach reach(sides, scene->corners(), scene->machine.radius_m);
    const PlacesByHeading planned = reach.from(scene->from, sense);
    for (int i = 0; i < 20; ++i) {
      const auto other = tramline::testing::random_drive_scene(random);
      if (!other) continue;
      if (!may_meet(planned, {arc_from(other->from, 0, 0, Gear::kForward)})) {
        ++ruled_out;
        EXPECT_FALSE(may_point(places, other->from));
      }
      if (i > 2 || may_meet(planned, reach.from(other->from, -1))) continue;
      EXPECT_FALSE(may_be_common(places, land.driven_from(other->from, -1)));
    }
  });
  std::cout << driven << " stretches driven, " << ruled_out << " places ruled out\n";
  if (tramline::testing::case_count(200) < 200) return;
  EXPECT_GT(driven, 1000);
  EXPECT_GT(ruled_out, 200);
}

}  // namespace
}  // namespace tramline::check
