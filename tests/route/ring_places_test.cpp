// The least times to and from closed passes, against the shortest ways of all places close together.

#include "tramline/route/build/ring_places.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "properties/draws.h"
#include "properties/seeds.h"
#include "route/rounded_rectangle.h"
#include "tramline/route/passes/pass_entries.h"
#include "tramline/turns/manoeuvres/dubins.h"
#include "tramline/turns/manoeuvres/reeds_shepp.h"

namespace tramline {
namespace {

using testing::for_each_seed;
using testing::rounded_rectangle;

Machine random_machine_with_ring(std::mt19937_64& random) {
  Machine out;
  out.radius_m = uniform(random, 3, 9);
  out.turning.lift_m = any_of(random, 0, 1) * uniform(random, 0, 3);
  out.turning.lower_m = any_of(random, 0, 1) * uniform(random, 0, 3);
  out.turning.reverse_speed_mps = uniform(random, 0.5, 1.4);
  out.turning.gear_change_s = uniform(random, 0, 3);
  out.turning.implement_offset_m = any_of(random, 0, 1) * uniform(random, -3, 5);
  return out;
}

HeadlandPass random_ring(std::mt19937_64& random, const Machine& machine) {
  return rounded_rectangle(uniform(random, 10, 60), uniform(random, 5, 40),
                           machine.radius_m * uniform(random, 1, 2));
}

double way_s(const Pose& from, double lift_m, const Pose& to, double lower_m, const Machine& machine) {
  const Turning& turning = machine.turning;
  const double forward_m =
      lift_m + lower_m + dubins_length(moved_on(from, lift_m), moved_on(to, -lower_m), machine.radius_m);
  return std::min(
      forward_m / turning.turning_speed_mps,
      2 * turning.gear_change_s + reeds_shepp_length(from, to, machine.radius_m) /
                                      std::max(turning.turning_speed_mps, turning.reverse_speed_mps));
}

/// All entries, from place to place a tenth of a metre.
std::vector<Pose> many_places(const HeadlandPass& pass, const Machine& machine, double spacing_m) {
  std::vector<Pose> out;
  for (const PassEntry& entry : entries_of(pass, spacing_m, machine.turning)) out.push_back(entry.entered);
  return out;
}

/// No way is quicker than what is said, and some way hardly slower.
void expect_bounds(double said_s, double quickest_s, double most_less_s) {
  EXPECT_LE(said_s, quickest_s + 1e-9);
  EXPECT_GE(said_s, quickest_s - most_less_s - 1e-9);
}

TEST(RingPlaces, AreHalfAMetreApartOrAThousand) {
  // 2·(30 + 20) + 2·π·5 = 131.4 m; 2·(400 + 300) + 31.4 = 1431.4 m.
  const RingPlaces small = ring_places(rounded_rectangle(30, 20, 5), {}),
                   large = ring_places(rounded_rectangle(400, 300, 5), {});
  EXPECT_EQ(small.senses[0].size(), 263U);
  EXPECT_EQ(small.senses[1].size(), 263U);
  EXPECT_NEAR(small.step_m, (100 + 10 * std::numbers::pi) / 263, 1e-9);
  EXPECT_EQ(large.senses[0].size(), 1000U);
}

TEST(RingPlaces, AreReachedAndLeftNoSoonerThanAllPlacesCloseTogether) {
  for_each_seed(60, [](std::mt19937_64& random, int) {
    const Machine machine = random_machine_with_ring(random);
    const HeadlandPass pass = random_ring(random, machine);
    const RingPlaces ring = ring_places(pass, machine.turning);
    const LeastSeconds least(machine);
    const Pose end{{uniform(random, -50, 50), uniform(random, -40, 40)},
                   Heading::clockwise_from_north(Angle::degrees(uniform(random, 0, 360)))};
    double from_s = std::numeric_limits<double>::max(), to_s = from_s, apart_m = from_s;
    for (const Pose& place : many_places(pass, machine, 0.1)) {
      from_s = std::min(from_s, way_s(place, 0, end, machine.turning.lower_m, machine));
      to_s = std::min(to_s, way_s(end, machine.turning.lift_m, place, 0, machine));
      apart_m = std::min(apart_m, distance(place.at, end.at));
    }
    // A place is a step from the next: less by the step, and by what it would take to drive on to there.
    // Distances are to every other place.
    const double step_s = ring.step_m / machine.turning.turning_speed_mps;
    expect_bounds(least_from_ring(ring, end, machine.turning.lower_m, least), from_s, 2 * step_s);
    expect_bounds(least_to_ring(end, machine.turning.lift_m, ring, least), to_s, 2 * step_s);
    expect_bounds(least_distance_m(ring, end.at), apart_m, 1.5 * (2 * ring.step_m));
  });
}

TEST(RingPlaces, OfTwoRingsAreReachedNoSoonerThanAllPlacesCloseTogether) {
  for_each_seed(6, [](std::mt19937_64& random, int) {
    const Machine machine = random_machine_with_ring(random);
    const double long_m = uniform(random, 10, 30), wide_m = uniform(random, 5, 20);
    const double apart = uniform(random, 2, 20);
    const HeadlandPass inner = rounded_rectangle(long_m, wide_m, machine.radius_m),
                       outer = rounded_rectangle(long_m, wide_m, machine.radius_m + apart);
    const RingPlaces from = ring_places(inner, machine.turning), to = ring_places(outer, machine.turning);
    const LeastSeconds least(machine);
    double quickest_s = std::numeric_limits<double>::max();
    const std::vector<Pose> places = many_places(inner, machine, 0.5),
                            others = many_places(outer, machine, 0.5);
    for (const Pose& place : places)
      for (const Pose& other : others)
        if (distance(place.at, other.at) < quickest_s * 1.5)
          quickest_s =
              std::min({quickest_s, way_s(place, 0, other, 0, machine), way_s(other, 0, place, 0, machine)});
    const double steps_s = (from.step_m + to.step_m) / machine.turning.turning_speed_mps;
    expect_bounds(least_between_rings(from, to, least), quickest_s, 2 * steps_s);
    EXPECT_DOUBLE_EQ(least_between_rings(to, from, least), least_between_rings(from, to, least));
    expect_bounds(least_distance_m(from, to), apart, 2 * (from.step_m + 1.5 * to.step_m));
  });
}

// Along the machine's own circle there is a way of 12 m. By a rounded coordinate the next place lies inside
// it, and no machine of that radius gets there but by another circle or two.
TEST(LeastSeconds, OfASlightlyTighterMachineHaveNoCircleByRounding) {
  Machine machine;
  machine.radius_m = 10;
  const LeastSeconds least(slightly_tighter(machine), 100);
  const Pose from{{3, 4}, Heading::clockwise_from_north(Angle::degrees(20))};
  for (const double inside_m : {0.0, 1e-12, 1e-9, 1e-7}) {
    Pose to = tramline::end_of(arc_from(from, 12, 0.1, Gear::kForward));
    to.at = to.at + inside_m * left_of(to.heading.unit());
    EXPECT_LE(least.between(from, to), 12 / machine.turning.turning_speed_mps + 1e-3) << inside_m;
    EXPECT_GE(least.between(from, to), 11.99 / machine.turning.turning_speed_mps) << inside_m;
  }
}

}  // namespace
}  // namespace tramline
