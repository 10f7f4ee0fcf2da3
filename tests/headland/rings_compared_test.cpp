// What rings leave and double beside others, against polygons with chords.

#include "tramline/headland/passages/rings_compared.h"

#include <gtest/gtest.h>

#include "properties/draws.h"
#include "properties/seeds.h"
#include "route/rounded_rectangle.h"
#include "support/box_ring.h"
#include "tramline/geometry/path/band_on_circles.h"
#include "tramline/geometry/polygon/boolean.h"

namespace tramline {
namespace {

using testing::for_each_seed;

using testing_support::box;

HeadlandPass random_ring(std::mt19937_64& random) {
  HeadlandPass out =
      testing::rounded_rectangle(uniform(random, 10, 60), uniform(random, 10, 40), uniform(random, 6, 12));
  const Point moved{uniform(random, -40, 40), uniform(random, -40, 40)};
  for (PathSegment& segment : out.path) {
    segment.from = segment.from + moved;
    segment.to = segment.to + moved;
  }
  return out;
}

Region bands_of(const std::vector<HeadlandPass>& rings, double width_m) {
  Region out;
  for (const HeadlandPass& ring : rings)
    for (const PathSegment& segment : ring.path)
      out = unite(out, {{band_on_circles({segment}, width_m, 1e-4), {}}});
  return out;
}

/// Ground left, times kMissedToDoubled, and what is worked elsewhere or again, of all rings together.
double missed_and_doubled_m2(const std::vector<HeadlandPass>& rings, const GroundToWork& to_work,
                             const std::vector<HeadlandPass>& before) {
  double worked_m2 = 0;
  for (const HeadlandPass& ring : rings) worked_m2 += to_work.width_m * length(ring.path);
  const Region fresh = intersection(
      difference(bands_of(rings, to_work.width_m), bands_of(before, to_work.width_m)), to_work.ground);
  return worked_m2 - area(fresh) + kMissedToDoubled * (area(to_work.ground) - area(fresh));
}

TEST(RingsCompared, DifferByWhatAllOfThemTogetherLeaveAndDouble) {
  for_each_seed(35, [](std::mt19937_64& random, int) {
    const Region ground{{box(-60, -50, 60, 50), {}}};
    const GroundToWork to_work{ground, {}, uniform(random, 3, 10)};
    std::vector<HeadlandPass> rings, than, before;
    for (int i = any_of(random, 0, 3); i > 0; --i) rings.push_back(random_ring(random));
    than = rings;
    for (int i = any_of(random, 0, 2); i > 0; --i) rings.push_back(random_ring(random));
    for (int i = any_of(random, 0, 2); i > 0; --i) than.push_back(random_ring(random));
    for (int i = any_of(random, 0, 2); i > 0; --i) before.push_back(random_ring(random));
    const double difference_m2 =
        missed_and_doubled_m2(rings, to_work, before) - missed_and_doubled_m2(than, to_work, before);
    EXPECT_NEAR(more_missed_and_doubled_m2(rings, than, to_work, before), difference_m2, 2);
    EXPECT_NEAR(more_missed_and_doubled_m2(than, rings, to_work, before), -difference_m2, 2);
  });
}

// A ring all on the ground works it once: 5 m² for each square metre of its band.
TEST(RingsCompared, ARingOnTheGroundIsBetterThanNone) {
  const Region ground{{box(-60, -50, 60, 50), {}}};
  const GroundToWork to_work{ground, {}, 6};
  const HeadlandPass ring = testing::rounded_rectangle(50, 30, 8);
  EXPECT_NEAR(more_missed_and_doubled_m2({ring}, {}, to_work, {}), -kMissedToDoubled * 6 * length(ring.path),
              1e-6);
  EXPECT_TRUE(are_better({ring}, {}, to_work, {}));
  EXPECT_FALSE(are_better({}, {ring}, to_work, {}));
  EXPECT_FALSE(are_better({ring}, {ring}, to_work, {}));
  // The same land once more is doubled.
  EXPECT_NEAR(more_missed_and_doubled_m2({ring}, {}, to_work, {ring}), 6 * length(ring.path), 1e-6);
}

}  // namespace
}  // namespace tramline
