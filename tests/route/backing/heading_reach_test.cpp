// Where machines get on convex land, against ways driven at random.

#include "tramline/route/backing/heading_reach.h"

#include <gtest/gtest.h>

#include <iostream>
#include <numbers>

#include "properties/random_drive.h"
#include "properties/seeds.h"
#include "tramline/route/axle/axle_path.h"

namespace tramline {
namespace {

using testing::for_each_seed;

Heading heading_deg(double clockwise_from_north) {
  return Heading::clockwise_from_north(Angle::degrees(clockwise_from_north));
}

std::vector<HeadingReach::Side> sides_of(const Ring& convex) {
  std::vector<HeadingReach::Side> out;
  for (std::size_t i = 0; i < convex.size(); ++i) {
    const Point edge = convex[(i + 1) % convex.size()] - convex[i];
    out.push_back({convex[i], left_of(1 / std::hypot(edge.x, edge.y) * edge)});
  }
  return out;
}

/// A strip towards the north, 200 m long, and a bar of 12 m that turns by 6 m.
HeadingReach on_a_strip(double wide_m) {
  Machine machine;
  machine.width_m = 12;
  machine.radius_m = 6;
  return {sides_of({{0, 0}, {wide_m, 0}, {wide_m, 200}, {0, 200}}),
          testing::DriveScene{machine, {}, {{0, 0}, heading_deg(0)}}.corners(), machine.radius_m};
}

// A bar of 12 m turns by 6 m. It begins 6 m off the western edge of a strip, towards the north, and turns
// round where it stands 12 m farther east at the other end of half a circle, and has 6 m beyond it: on 24 m.
// On 21 m it still turns by a right angle, 12 m off the edge, and comes back to its heading.
TEST(HeadingReach, TurnsRoundWhereTheStripIsAsWideAsItsTurnAndItsBar) {
  const auto reached = [](double wide_m, const Pose& pose) {
    return may_meet(on_a_strip(wide_m).from({{6, 60}, heading_deg(0)}, 1), pose);
  };
  EXPECT_TRUE(reached(24.1, {{18, 60}, heading_deg(180)}));
  EXPECT_FALSE(reached(21, {{15, 60}, heading_deg(180)}));
  EXPECT_TRUE(reached(21, {{12, 66}, heading_deg(90)}));
  EXPECT_TRUE(reached(21, {{14, 150}, heading_deg(0)}));
  EXPECT_FALSE(reached(21, {{6, 50}, heading_deg(0)}));  // not behind where it began
}

// Backing from a place leads to where driving on to it leads from.
TEST(HeadingReach, InReverseIsWhatLeadsThere) {
  const HeadingReach land = on_a_strip(21);
  const PlacesByHeading before = land.from({{14, 150}, heading_deg(0)}, -1);
  EXPECT_TRUE(may_meet(before, {{6, 60}, heading_deg(0)}));
  EXPECT_FALSE(may_meet(before, {{6, 160}, heading_deg(0)}));
  EXPECT_TRUE(may_meet(before, land.from({{6, 60}, heading_deg(0)}, 1)));
  EXPECT_FALSE(may_meet(before, land.from({{6, 160}, heading_deg(0)}, 1)));
}

// Where the machine cannot turn round it gets to no place behind the one where it begins, nor to any that
// points the other way.
TEST(HeadingReach, TellsWhetherALineIsMet) {
  const PlacesByHeading places = on_a_strip(21).from({{6, 60}, heading_deg(0)}, 1);
  const auto meets = [&](double y, double towards) {
    return may_meet(places, {arc_from({{6, y}, heading_deg(towards)}, 15, 0, Gear::kForward)});
  };
  EXPECT_FALSE(meets(44, 0));
  EXPECT_TRUE(meets(46, 0));
  EXPECT_FALSE(meets(120, 180));
}

TEST(HeadingReach, HoldsAllThatIsDrivenAtRandom) {
  int driven = 0, followed = 0;
  for_each_seed(200, [&](std::mt19937_64& random, int) {
    const auto scene = testing::random_drive_scene(random);
    if (!scene) return;
    const HeadingReach reach(sides_of(scene->land), scene->corners(), scene->machine.radius_m);
    const PlacesByHeading places = reach.from(scene->from, scene->gear == Gear::kForward ? 1 : -1);
    if (places.followed) ++followed;
    for (int i = 0; i < 20; ++i) {
      const SteeredPath path = testing::driven_at_random(*scene, random);
      for (const SteeredStretch& stretch : path) {
        ++driven;
        EXPECT_TRUE(may_meet(places, end_of(stretch)));
        const Pose before = moved_on(end_of(stretch), -7);
        EXPECT_TRUE(may_meet(places, {arc_from(before, 14, 0, Gear::kForward)}));
      }
      if (i > 0 || path.empty()) continue;
      // Where it stops to back it has room.
      EXPECT_TRUE(may_meet(places, reach.from(end_of(path), -1)));
    }
  });
  std::cout << driven << " stretches driven, " << followed << " machines followed to all places\n";
  if (testing::case_count(200) < 200) return;
  EXPECT_GT(driven, 1000);
  EXPECT_GT(followed, 20);
}

}  // namespace
}  // namespace tramline
