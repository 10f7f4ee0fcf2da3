// Land that several swaths work: by hand, and against the overlays of all pairs.

#include "tramline/cost/worked/swath_union.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>

#include "properties/seeds.h"
#include "tramline/cost/worked/doubled_ground.h"
#include "tramline/geometry/path/band_on_circles.h"
#include "tramline/geometry/polygon/boolean.h"
#include "tramline/geometry/tolerances.h"

namespace tramline::swath_union_test {

constexpr double kWidth = 4;

Polygon box_of(double min_x, double min_y, double max_x, double max_y) {
  return {{{min_x, min_y}, {max_x, min_y}, {max_x, max_y}, {min_x, max_y}}, {}};
}

// Three columns of 2 m × 10 m, each a metre beside the one before: 4 m wide together, of which the outer
// metres are worked once.
TEST(SwathUnion, OfThreeThatLieOnOneAnother) {
  const SwathUnion found = swath_union({box_of(0, 0, 2, 10), box_of(1, 0, 3, 10), box_of(2, 0, 4, 10)});
  EXPECT_NEAR(area(found.all), 40, 1e-9);
  EXPECT_NEAR(area(found.doubled), 20, 1e-9);
}

TEST(SwathUnion, OfNoneAndOfOne) {
  EXPECT_TRUE(swath_union({}).all.empty());
  const SwathUnion one = swath_union({box_of(0, 0, 2, 10)});
  EXPECT_NEAR(area(one.all), 20, 1e-12);
  EXPECT_TRUE(one.doubled.empty());
}

/// A detour along y = 0 round a circle about (x, 0), which its centre line passes at this distance.
Path detour_at(double x, double distance_m) {
  const double r = distance_m, along = std::sqrt(3.0) * r;
  return {{{x - along, 0}, {x - along / 2, r / 2}, 1 / r},
          {{x - along / 2, r / 2}, {x + along / 2, r / 2}, -1 / r},
          {{x + along / 2, r / 2}, {x + along, 0}, 1 / r}};
}

/// Detours that share arcs, run through one another or lie apart.
Region random_detours(std::mt19937_64& random) {
  std::uniform_real_distribution<double> place(0, 60), r(4, 12);
  std::bernoulli_distribution again(0.4);
  std::uniform_int_distribution<int> count(1, 7);
  Region out;
  double x = 0, radius = 6;
  for (int i = count(random); i > 0; --i) {
    if (!again(random)) {
      x = place(random);
      radius = r(random);
    } else if (again(random)) {
      radius += kWidth;
    }
    append_swath(detour_at(x, radius), kWidth, out);
  }
  return out;
}

/// What every pair has in common, united: the readable way.
Region doubled_by_pairs(const Region& swaths) {
  Region out;
  for (std::size_t i = 0; i < swaths.size(); ++i)
    for (std::size_t k = 0; k < i; ++k)
      for (const Polygon& both : intersection({swaths[i]}, {swaths[k]})) out.push_back(both);
  return unite(out);
}

TEST(SwathUnion, IsThatOfAllPairs) {
  testing::for_each_seed(6, [](std::mt19937_64& random, int) {
    const Region swaths = random_detours(random);
    const SwathUnion found = swath_union(swaths);
    double around_m = 0;
    for (const Polygon& swath : swaths) around_m += perimeter(swath.outer);
    // Slivers between chords are left out: half a sagitta beside all outlines at most.
    const double tolerance_m2 = 0.5 * kLayerSagitta * around_m;
    EXPECT_NEAR(area(found.all), area(unite(swaths)), 1e-6 * around_m);
    EXPECT_NEAR(area(found.doubled), area(doubled_by_pairs(swaths)), tolerance_m2);
    EXPECT_NEAR(area(symmetric_difference(found.doubled, doubled_by_pairs(swaths))), 0, tolerance_m2);
  });
}

TEST(UnitedRegions, AreOverlaidWhereTheyMeetAndKeptWhereTheyDoNot) {
  const Region united = united_regions(
      {{box_of(0, 0, 2, 2)}, {}, {box_of(5, 0, 6, 1)}, {box_of(1, 1, 3, 3), box_of(8, 8, 9, 9)}});
  EXPECT_NEAR(area(united), 4 + 1 + 4 - 1 + 1, 1e-9);
  EXPECT_EQ(united.size(), 3u);
  EXPECT_TRUE(united_regions({}).empty());
}

TEST(BandOnCircles, HasTheSameVerticesOnArcsOfOneCircle) {
  // Of one circle about the origin, r = 10 m: one from −20 to 70 degrees, the other from 10 to 100.
  const auto arc = [](double from_deg, double to_deg) {
    const auto at = [](double degrees) {
      const double angle = degrees * std::numbers::pi / 180;
      return Point{10 * std::cos(angle), 10 * std::sin(angle)};
    };
    return Path{{at(from_deg), at(to_deg), 0.1}};
  };
  const Ring one = band_on_circles(arc(-20, 70), kWidth, 1e-3),
             other = band_on_circles(arc(10, 100), kWidth, 1e-3);
  const auto in_both = std::count_if(one.begin(), one.end(), [&](Point p) {
    return std::any_of(other.begin(), other.end(), [&](Point q) { return distance(p, q) < 1e-9; });
  });
  // Both edges have chords of 2·acos(1 − s/r) at most: 2.01 degrees at 8 m, 1.48 at 12 m, over 60 degrees.
  EXPECT_GE(in_both, 60 / 2.02 + 60 / 1.49 - 4);
  EXPECT_LE(in_both, 60 / 1.9 + 60 / 1.4 + 2);
  // A quarter of the ring between 8 and 12 m, but for what chords cut off and add.
  EXPECT_NEAR(signed_area(one), std::numbers::pi / 4 * (144 - 64), 10 * std::numbers::pi * 1e-3);
}

}  // namespace tramline::swath_union_test
