// Where machines get on convex land, against ways driven at random.

#include "tramline/route/backing/heading_reach.h"

#include <gtest/gtest.h>

#include <iostream>
#include <numbers>

#include "properties/draws.h"
#include "properties/seeds.h"
#include "tramline/geometry/polygon/bounding_rectangle.h"
#include "tramline/route/axle/axle_path.h"
#include "tramline/turns/outline/outline.h"
#include "tramline/turns/room/allowed_land.h"

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

std::vector<Point> corners_of_outline(const Machine& machine) {
  std::vector<Point> out;
  for (const Box& box : outline_of(machine).on_machine)
    for (const Point corner : corners_of(box)) out.push_back(corner);
  return out;
}

SteeredPath standing_at(const Pose& pose) { return {arc_from(pose, 0, 0, Gear::kForward)}; }

bool may_point(const PlacesByHeading& places, const Pose& pose) {
  return may_meet(places, standing_at(pose));
}

// A bar of 12 m turns by 6 m. It begins 6 m off the western edge of a strip, towards the north, and turns
// round where it stands 12 m farther east at the other end of half a circle, and has 6 m beyond it: on 24 m.
// On 21 m it still turns by a right angle, 12 m off the edge, and comes back to its heading.
TEST(HeadingReach, TurnsRoundWhereTheStripIsAsWideAsItsTurnAndItsBar) {
  Machine machine;
  machine.width_m = 12;
  machine.radius_m = 6;
  const auto reached = [&](double wide_m, const Pose& pose) {
    const HeadingReach land(sides_of({{0, 0}, {wide_m, 0}, {wide_m, 200}, {0, 200}}),
                            corners_of_outline(machine), machine.radius_m);
    return may_point(land.from({{6, 60}, heading_deg(0)}, 1), pose);
  };
  EXPECT_TRUE(reached(24.1, {{18, 60}, heading_deg(180)}));
  EXPECT_FALSE(reached(21, {{15, 60}, heading_deg(180)}));
  EXPECT_TRUE(reached(21, {{12, 66}, heading_deg(90)}));
  EXPECT_TRUE(reached(21, {{14, 150}, heading_deg(0)}));
  EXPECT_FALSE(reached(21, {{6, 50}, heading_deg(0)}));  // not behind where it began
}

// Backing from a place leads to where driving on to it leads from.
TEST(HeadingReach, InReverseIsWhatLeadsThere) {
  Machine machine;
  machine.width_m = 12;
  machine.radius_m = 6;
  const HeadingReach land(sides_of({{0, 0}, {21, 0}, {21, 200}, {0, 200}}), corners_of_outline(machine), 6);
  const PlacesByHeading before = land.from({{14, 150}, heading_deg(0)}, -1);
  EXPECT_TRUE(may_point(before, {{6, 60}, heading_deg(0)}));
  EXPECT_FALSE(may_point(before, {{6, 160}, heading_deg(0)}));
  EXPECT_TRUE(may_meet(before, land.from({{6, 60}, heading_deg(0)}, 1)));
  EXPECT_FALSE(may_meet(before, land.from({{6, 160}, heading_deg(0)}, 1)));
}

Ring random_convex_field(std::mt19937_64& random) {
  const double wide_m = uniform(random, 15, 70), long_m = uniform(random, 25, 90);
  std::vector<Point> corners;
  for (int i = 0; i < 9; ++i) corners.push_back({uniform(random, 0, wide_m), uniform(random, 0, long_m)});
  return hull_of(std::move(corners));
}

/// On from a pose by arcs and straight stretches as long as they have room.
SteeredPath driven_at_random(const Pose& from, Gear gear, const AllowedLand& land, const Machine& machine,
                             std::mt19937_64& random) {
  SteeredPath out;
  Pose at = from;
  for (int i = 0; i < 40; ++i) {
    const double sharp = any_of(random, 0, 2) == 0 ? uniform(random, -1, 1) : any_of(random, -1, 1);
    const SteeredPath next{arc_from(at, uniform(random, 0.5, 12), sharp / machine.radius_m, gear)};
    if (!land.fits(next, outline_of(machine))) continue;
    out.push_back(next.front());
    at = end_of(out);
  }
  return out;
}

TEST(HeadingReach, HoldsAllThatIsDrivenAtRandom) {
  int driven = 0, followed = 0;
  for_each_seed(200, [&](std::mt19937_64& random, int) {
    Machine machine;
    machine.width_m = uniform(random, 3, 24);
    machine.radius_m = uniform(random, 3, 9);
    if (any_of(random, 0, 1) == 1) {
      machine.turning.front_overhang_m = uniform(random, 0, 4);
      machine.turning.vehicle_width_m = 2;
      machine.turning.implement_offset_m = uniform(random, -2, 3);
    }
    const Ring field = random_convex_field(random);
    const AllowedLand land({{field, {}}});
    const Box box = bounds(field);
    const Pose from{{uniform(random, box.min_x, box.max_x), uniform(random, box.min_y, box.max_y)},
                    heading_deg(uniform(random, 0, 360))};
    if (!land.holds(from, outline_of(machine))) return;
    const Gear gear = any_of(random, 0, 1) == 0 ? Gear::kForward : Gear::kReverse;
    const HeadingReach reach(sides_of(field), corners_of_outline(machine), machine.radius_m);
    const PlacesByHeading places = reach.from(from, gear == Gear::kForward ? 1 : -1);
    if (places.followed) ++followed;
    for (int i = 0; i < 20; ++i) {
      const SteeredPath path = driven_at_random(from, gear, land, machine, random);
      for (const SteeredStretch& stretch : path) {
        ++driven;
        EXPECT_TRUE(may_point(places, end_of(stretch)));
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
