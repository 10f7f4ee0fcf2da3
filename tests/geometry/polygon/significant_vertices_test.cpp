#include "tramline/geometry/polygon/significant_vertices.h"

#include <gtest/gtest.h>

#include "geometry/random_shapes.h"
#include "tramline/geometry/polygon/boolean.h"

namespace tramline::significant_vertices_test {

using testing::RandomCase;
using Indices = std::vector<std::size_t>;

TEST(SignificantVertices, AreTheCornersOfARectangle) {
  const Ring ring{{0, 0}, {5, 0}, {10, 0}, {10, 3}, {10, 6}, {4, 6}, {0, 6}, {0, 1}};
  EXPECT_EQ(significant_vertices(ring, 0.01), (Indices{0, 2, 4, 6}));
}

// The same ring begun in the middle of its sides.
TEST(SignificantVertices, DoNotDependOnWhereTheRingBegins) {
  const Ring ring{{0, 0}, {5, 0}, {10, 0}, {10, 3}, {10, 6}, {4, 6}, {0, 6}, {0, 1}};
  for (std::size_t by = 0; by < ring.size(); ++by) {
    Ring begun = ring;
    std::rotate(begun.begin(), begun.begin() + static_cast<std::ptrdiff_t>(by), begun.end());
    std::vector<Point> kept;
    for (const std::size_t i : significant_vertices(begun, 0.01)) kept.push_back(begun[i]);
    ASSERT_EQ(kept.size(), 4U) << by;
    EXPECT_NEAR(signed_area(kept), 60, 1e-12) << by;
  }
}

TEST(SignificantVertices, CarryABumpThatIsDeeperThanTheTolerance) {
  const Ring ring{{0, 0}, {5, -0.5}, {10, 0}, {10, 6}, {0, 6}};
  EXPECT_EQ(significant_vertices(ring, 0.4), (Indices{0, 1, 2, 3, 4}));
  EXPECT_EQ(significant_vertices(ring, 0.6), (Indices{0, 2, 3, 4}));
}

// A chord of a circle leaves it by R·(1 − cos(α/2)): eight chords by 7.6 % of the radius, 16 by 1.9 %.
TEST(SignificantVertices, AreAsFewAsTheToleranceAllowsOfACircle) {
  Ring circle;
  for (int i = 0; i < 256; ++i) circle.push_back(turned({100, 0}, i * std::numbers::pi / 128));
  EXPECT_EQ(significant_vertices(circle, 7.7).size(), 8U);
  EXPECT_EQ(significant_vertices(circle, 1.95).size(), 16U);
  EXPECT_EQ(significant_vertices(circle, 1e-6).size(), 256U);
}

TEST(SignificantVertices, KeepTheRingWithinTheTolerance) {
  std::size_t dropped = 0, kept_ones = 0;
  for (int number = 0; number < 300; ++number) {
    RandomCase random(number);
    const Ring ring = testing::random_star(random, {20, -30}, 40, 50, random.whole(5, 80));
    const double tolerance = random.between(0.1, 8);
    const Indices kept = significant_vertices(ring, tolerance);
    ASSERT_GE(kept.size(), 3U);
    ASSERT_TRUE(std::adjacent_find(kept.begin(), kept.end(), std::greater_equal<>()) == kept.end());
    ASSERT_LT(kept.back(), ring.size());
    for (std::size_t k = 0; k < kept.size(); ++k) {
      const std::size_t from = kept[k], to = kept[(k + 1) % kept.size()];
      for (std::size_t i = (from + 1) % ring.size(); i != to; i = (i + 1) % ring.size()) {
        ASSERT_LE(distance_to_segment(ring[i], ring[from], ring[to]), tolerance) << i;
        ++dropped;
      }
    }
    kept_ones += kept.size();
  }
  EXPECT_GT(dropped, 1000U);
  EXPECT_GT(kept_ones, 1000U);
}

// A rectangle with a bump on one side and a hole with a dent: half of either is within the tolerance.
TEST(Simplified, LeavesOutWhatIsWithinTheToleranceInAllRings) {
  const Polygon polygon{{{0, 0}, {5, -0.1}, {10, 0}, {10, 8}, {5, 9}, {0, 8}},
                        {{{2, 2}, {2, 4}, {3, 4.05}, {4, 4}, {4, 2}}}};
  const Polygon expected{{{0, 0}, {10, 0}, {10, 8}, {5, 9}, {0, 8}}, {{{2, 2}, {2, 4}, {4, 4}, {4, 2}}}};
  EXPECT_EQ(simplified(polygon, 0.2), expected);
}

// Without its bump the side would run through the hole.
TEST(Simplified, IsThePolygonItselfWhereFewerVerticesWouldCross) {
  const Polygon polygon{{{0, 0}, {5, -0.3}, {10, 0}, {10, 8}, {0, 8}},
                        {{{4.5, -0.1}, {4.5, 4}, {5.5, 4}, {5.5, -0.1}}}};
  ASSERT_FALSE(find_invalidity(polygon));
  EXPECT_EQ(simplified(polygon, 0.5), polygon);
}

}  // namespace tramline::significant_vertices_test
