// Where machines have to stop on their ways to closed passes and from there, against ways tried at random.

#include <gtest/gtest.h>

#include <array>
#include <iostream>

#include "properties/draws.h"
#include "properties/seeds.h"
#include "route/backing/backing_scenes.h"
#include "route/rounded_rectangle.h"
#include "tramline/route/axle/axle_path.h"
#include "tramline/route/backing/least_backing.h"
#include "tramline/turns/manoeuvres/dubins.h"
#include "tramline/turns/outline/outline.h"
#include "tramline/turns/room/allowed_land.h"

namespace tramline {
namespace {

using testing::for_each_seed;
using testing::north_to;
using testing::random_line;
using testing::random_machine_that_backs;
using testing::rectangle_of;
using testing::six_metres;
using testing::south_from;

/// The axle's way round a rectangle so far within its sides, either way, with corners as it turns.
std::array<SteeredPath, 2> round_within(double wide_m, double long_m, double within_m,
                                        const Machine& machine) {
  const double radius_m = machine.radius_m;
  HeadlandPass pass = testing::rounded_rectangle(wide_m - 2 * (within_m + radius_m),
                                                 long_m - 2 * (within_m + radius_m), radius_m);
  const Point middle{wide_m / 2, long_m / 2};
  for (PathSegment& segment : pass.path) {
    segment.from = segment.from + middle;
    segment.to = segment.to + middle;
  }
  return {steered(pass.path), steered(reversed(pass.path))};
}

// To turn aside from a track takes r + w/2 = 9 m to the edge ahead. Where it ends 8 m from there the machine
// stops on its way to the pass along the edge, which is 5 m away; likewise on its way back from there.
TEST(LeastBacking, ToAClosedPassIsAStopWhereNoWayForwardLeadsToIt) {
  const Machine machine = six_metres();
  constexpr double kStop_s = 100;
  const LeastBacking backing(rectangle_of(100, 200), 0, machine, kStop_s, LeastBacking::Places::kFollowed);
  const auto ring = round_within(100, 200, 3, machine);
  const auto to_ring_s = [&](const LineExits& exits) { return backing.to_ring(exits, ring, 5, 1); };
  EXPECT_DOUBLE_EQ(to_ring_s(backing.left(north_to({40, 192}, 150))), kStop_s + 2 * 2 + 5 / 1.5);
  EXPECT_DOUBLE_EQ(to_ring_s(backing.entered(south_from({40, 192}, 150))), kStop_s + 2 * 2 + 5 / 1.5);
  EXPECT_DOUBLE_EQ(to_ring_s(backing.left(north_to({40, 188}, 150))), 1);
  EXPECT_DOUBLE_EQ(to_ring_s(backing.entered(south_from({40, 188}, 150))), 1);
  const LeastBacking not_followed(rectangle_of(100, 200), 0, machine, kStop_s);
  EXPECT_DOUBLE_EQ(not_followed.to_ring(not_followed.left(north_to({40, 192}, 150)), ring, 5, 1), 1);
}

// Where any forward way that is tried from a line to a closed pass, or back, has room, no stop is asked for.
TEST(LeastBacking, AsksForNoStopWhereAWayLeadsForwardToAClosedPass) {
  int asked = 0, driven = 0;
  for_each_seed(200, [&](std::mt19937_64& random, int) {
    const Machine machine = random_machine_that_backs(random);
    const double least_m = machine.width_m + 2 * machine.radius_m;
    const double wide_m = least_m + uniform(random, 0.1, 15), long_m = wide_m + uniform(random, 5, 60);
    const Ring field = rectangle_of(wide_m, long_m);
    const AllowedLand land({{field, {}}});
    const auto line = random_line(field, land, machine, random);
    if (!line) return;
    const auto ring = round_within(wide_m, long_m, machine.width_m / 2, machine);
    const LeastBacking backing(field, 0, machine, 100, LeastBacking::Places::kFollowed);
    const bool stops = backing.to_ring(backing.left(line->driven), ring, 0, 0) > 0;
    asked += stops ? 1 : 0;
    const Outline outline = outline_of(machine);
    bool fits = false;
    for (int i = 0; i < 300 && !fits; ++i) {
      const SteeredPath& round = ring[static_cast<std::size_t>(any_of(random, 0, 1))];
      const Pose place = pose_on(round, uniform(random, 0, length(round)));
      for (const Manoeuvre& way : dubins_words(end_of(line->driven), place, machine.radius_m))
        fits = fits || land.fits(way.path, outline);
    }
    driven += fits ? 1 : 0;
    EXPECT_FALSE(stops && fits);
    // The way from the pass is the same turned round.
    const LineExits back = backing.entered(turned_round(line->driven));
    if (machine.turning.implement_offset_m == 0 && machine.turning.front_overhang_m == 0) {
      EXPECT_EQ(backing.to_ring(back, ring, 0, 0) > 0, stops);
    }
  });
  EXPECT_GT(asked, 0);
  EXPECT_GT(driven, 0);
  std::cout << asked << " lines with a stop, " << driven << " with a way forward\n";
}

}  // namespace
}  // namespace tramline
