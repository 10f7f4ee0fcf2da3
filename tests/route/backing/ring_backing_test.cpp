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
// stops on its way to the pass along the edge; likewise on its way back from there. It backs out 1 m, and a
// quarter of a circle of 6 m leads to the pass, 5 m from where the track ends.
TEST(LeastBacking, ToAClosedPassIsAStopWhereNoWayForwardLeadsToIt) {
  const Machine machine = six_metres();
  constexpr double kStop_s = 100;
  const LeastBacking backing(rectangle_of(100, 200), 0, machine, kStop_s, LeastBacking::Places::kFollowed);
  const auto ring = round_within(100, 200, 3, machine);
  // The least arc to the line y = 197, aside by no more than a quarter of a circle.
  const auto on_s = [&](const Pose& from) {
    const double to_line_m = 197 - from.at.y;
    return (to_line_m < 6 ? 1000 : 0.5 * std::numbers::pi * 6 + to_line_m - 6) / 1.5;
  };
  const auto to_ring_s = [&](const LineExits& exits) { return backing.to_ring(exits, ring, on_s, 1); };
  const double backed_s = kStop_s + 2 * 2 + 1 + 0.5 * std::numbers::pi * 6 / 1.5;
  for (const LineExits& exits :
       {backing.left(north_to({40, 192}, 150)), backing.entered(south_from({40, 192}, 150))}) {
    EXPECT_LE(to_ring_s(exits), backed_s);
    EXPECT_GE(to_ring_s(exits), backed_s - 0.5);
  }
  EXPECT_DOUBLE_EQ(to_ring_s(backing.left(north_to({40, 188}, 150))), 1);
  EXPECT_DOUBLE_EQ(to_ring_s(backing.entered(south_from({40, 188}, 150))), 1);
  const LeastBacking not_followed(rectangle_of(100, 200), 0, machine, kStop_s);
  EXPECT_DOUBLE_EQ(not_followed.to_ring(not_followed.left(north_to({40, 192}, 150)), ring, on_s, 1), 1);
}

constexpr double kStopTried_s = 100;

/// Ways to the pass from any place of the line to which the machine has backed, by words of Dubins; how many
/// of them have room.
int expect_no_more_than_ways_tried(const LeastBacking& backing, const SteeredPath& line,
                                   const std::array<SteeredPath, 2>& ring, const AllowedLand& land,
                                   const Machine& machine, std::mt19937_64& random) {
  const Outline outline = outline_of(machine);
  const LeastSeconds least(machine, kStopTried_s);
  constexpr double kStep_m = 0.5;
  const auto on_s = [&](const Pose& from) {
    double out_s = 1e9;
    for (const SteeredPath& round : ring)
      for (double at_m = 0; at_m < length(round); at_m += kStep_m)
        out_s = std::min(out_s, least.between(from, 0, pose_on(round, at_m), 0, 1e9));
    return std::max(0.0, out_s - kStep_m / machine.turning.turning_speed_mps);
  };
  const double found_s = backing.to_ring(backing.left(line), ring, on_s, 0);
  int tried = 0;
  for (int i = 0; i < 100; ++i) {
    const double back_m = uniform(random, 0, length(line));
    const SteeredPath& round = ring[static_cast<std::size_t>(any_of(random, 0, 1))];
    const Pose from = pose_on(line, length(line) - back_m);
    for (const Manoeuvre& way :
         dubins_words(from, pose_on(round, uniform(random, 0, length(round))), machine.radius_m))
      if (land.fits(way.path, outline)) {
        ++tried;
        EXPECT_LE(found_s, kStopTried_s + 2 * machine.turning.gear_change_s +
                               back_m / machine.turning.reverse_speed_mps +
                               length(way.path) / machine.turning.turning_speed_mps);
      }
  }
  return tried;
}

// Where any forward way that is tried from a line to a closed pass, or back, has room, no stop is asked for.
TEST(LeastBacking, AsksForNoStopWhereAWayLeadsForwardToAClosedPass) {
  int asked = 0, driven = 0, backed = 0;
  for_each_seed(200, [&](std::mt19937_64& random, int) {
    const Machine machine = random_machine_that_backs(random);
    const double least_m = machine.width_m + 2 * machine.radius_m;
    const double wide_m = least_m + uniform(random, 0.1, 15), long_m = wide_m + uniform(random, 5, 60);
    const Ring field = rectangle_of(wide_m, long_m);
    const AllowedLand land({{field, {}}});
    const auto line = random_line(field, land, machine, random);
    if (!line) return;
    const auto ring = round_within(wide_m, long_m, machine.width_m / 2, machine);
    const LeastBacking backing(field, 0, machine, kStopTried_s, LeastBacking::Places::kFollowed);
    const auto on_s = [](const Pose&) { return 0.0; };
    const bool stops = backing.to_ring(backing.left(line->driven), ring, on_s, 0) > 0;
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
    if (stops) backed += expect_no_more_than_ways_tried(backing, line->driven, ring, land, machine, random);
    // The way from the pass is the same turned round.
    const LineExits back = backing.entered(turned_round(line->driven));
    if (machine.turning.implement_offset_m == 0 && machine.turning.front_overhang_m == 0) {
      EXPECT_EQ(backing.to_ring(back, ring, on_s, 0) > 0, stops);
    }
  });
  EXPECT_GT(asked, 0);
  EXPECT_GT(driven, 0);
  EXPECT_GT(backed, 0);
  std::cout << asked << " lines with a stop (" << backed << " ways that back first), " << driven
            << " with a way forward\n";
}

}  // namespace
}  // namespace tramline
