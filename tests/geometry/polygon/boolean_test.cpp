#include "tramline/geometry/polygon/boolean.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "geometry/random_shapes.h"

namespace tramline::boolean_test {

Polygon box(double x0, double y0, double x1, double y1) {
  return {{{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}}, {}};
}

TEST(Booleans, KeepAreas) {
  EXPECT_NEAR(area(unite({box(0, 0, 2, 2), box(1, 1, 3, 3)})), 7, 1e-9);
  EXPECT_NEAR(area(intersection({box(0, 0, 2, 2)}, {box(1, 1, 3, 3)})), 1, 1e-9);
  EXPECT_NEAR(area(difference({box(0, 0, 2, 2)}, {box(1, 1, 3, 3)})), 3, 1e-9);
  EXPECT_NEAR(area(symmetric_difference({box(0, 0, 2, 2)}, {box(1, 1, 3, 3)})), 6, 1e-9);
  EXPECT_TRUE(intersection({box(0, 0, 1, 1)}, {}).empty());
}

// The trap of the floating union: many rectangles that touch within rounding error.
TEST(Booleans, UniteTouchingTurnedRectanglesWithoutLosingAny) {
  const Point u{std::sin(0.3), std::cos(0.3)}, v{std::cos(0.3), -std::sin(0.3)};
  Region strips;
  for (int i = 0; i < 200; ++i) {
    const Point a = (3.0 * i) * v, b = (3.0 * (i + 1)) * v;
    strips.push_back({{a, b, b + 331.7 * u, a + 331.7 * u}, {}});
  }
  EXPECT_NEAR(area(unite(strips)), 200 * 3 * 331.7, 0.01);
}

// GEOS refuses such a region: "side location conflict". The two squares share a strip of half a millimetre.
TEST(Booleans, TakeRegionsWhosePolygonsOverlapALittle) {
  const Region overlapping{box(0, 0, 2, 2), box(1.9995, 0, 4, 2)}, window{box(1, 0, 3, 2)};
  EXPECT_NEAR(area(intersection(overlapping, window)), 4, 1e-9);
  EXPECT_NEAR(area(difference(overlapping, window)), 4, 1e-9);
  EXPECT_NEAR(area(difference(window, overlapping)), 0, 1e-9);
  EXPECT_NEAR(area(unite(overlapping, window)), 8, 1e-9);
}

TEST(Booleans, BufferBothWays) {
  EXPECT_NEAR(area(buffered({box(0, 0, 10, 10)}, 1, JoinStyle::kMitre)), 144, 1e-9);
  EXPECT_NEAR(area(buffered({box(0, 0, 10, 10)}, -1)), 64, 1e-9);
  EXPECT_NEAR(area(buffered_line({{0, 0}, {10, 0}}, 1.5)), 30, 1e-9);
}

// GEOS takes the offset curve of this one for inverted, because of its edge of a micrometre.
TEST(Booleans, ErodeSmallPolygonsWithAShortEdge) {
  const Polygon part{{{0.507985, -10.531549},
                      {-0.951507, -10.185309},
                      {-1.208620, -10.124313},
                      {-1.543919, -13.577695},
                      {-0.265135, -13.790444},
                      {0.507985, -10.531550}},
                     {}};
  EXPECT_GT(area(buffered({part}, -0.69)), 0.2);
  EXPECT_GT(area(buffered({part}, -0.70)), 0.2);
  EXPECT_GT(area(buffered({box(20, 0, 30, 10), part}, -0.70)), 8.6 * 8.6 + 0.2);
}

/// What of a convex ring is at least so far from all of its edges.
Ring inset(const Ring& ring, double distance_m) {
  Ring out = ring;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Point from = ring[i], way = ring[(i + 1) % ring.size()] - from;
    const auto beyond_m = [&](Point p) { return cross(way, p - from) / length(way) - distance_m; };
    Ring kept;
    for (std::size_t k = 0; k < out.size(); ++k) {
      const Point p = out[k], q = out[(k + 1) % out.size()];
      const double at_p = beyond_m(p), at_q = beyond_m(q);
      if (at_p >= 0) kept.push_back(p);
      if ((at_p >= 0) != (at_q >= 0)) kept.push_back(p + at_p / (at_p - at_q) * (q - p));
    }
    out = std::move(kept);
  }
  return out;
}

/// Three to seven corners on an ellipse, one of them cut off by an edge of a micrometre up to 0.3 m.
Ring with_a_short_edge(testing::RandomCase& random) {
  std::vector<double> angles(static_cast<std::size_t>(random.whole(3, 7)));
  for (double& angle : angles) angle = random.between(0, 2 * std::numbers::pi);
  std::ranges::sort(angles);
  const double wide = random.between(1, 11), high = random.between(1, 4);
  Ring ring;
  for (const double angle : angles) ring.push_back({wide * std::cos(angle), high * std::sin(angle)});
  const Point cut = ring.front(), before = ring.back(), after = ring[1];
  const double nearest = std::min(distance(cut, before), distance(cut, after));
  const double back_m = std::min(std::pow(10, random.between(-6, -0.5)), 0.3 * nearest);
  ring.front() = cut + back_m / distance(cut, after) * (after - cut);
  ring.push_back(cut + back_m / distance(cut, before) * (before - cut));
  return ring;
}

TEST(Booleans, ErodeConvexPolygonsAsTheirEdgesMovedInwards) {
  int some_left = 0;
  for (int number = 0; number < 10000; ++number) {
    testing::RandomCase random(number);
    const Ring ring = with_a_short_edge(random);
    const double distance_m = random.between(0.05, 1.25);
    const Ring expected = inset(ring, distance_m);
    const double expected_m2 = expected.size() < 3 ? 0 : signed_area(expected);
    // GEOS leaves out vertices that are nearer to an edge than a hundredth of the distance.
    ASSERT_NEAR(area(buffered({{ring, {}}}, -distance_m, JoinStyle::kMitre)), expected_m2,
                0.01 * distance_m * perimeter(ring));
    if (expected_m2 > 0.5) ++some_left;
  }
  EXPECT_GT(some_left, 3000);
}

TEST(Booleans, MeasureDistances) {
  EXPECT_NEAR(distance_between({box(0, 0, 1, 1)}, {box(4, 5, 6, 6)}), 5, 1e-12);
  EXPECT_NEAR(distance_to_ring({box(4, 4, 5, 5)}, box(0, 0, 10, 10).outer), 4, 1e-12);
}

TEST(Booleans, SplitByLinesGivesFacesThatShareEdges) {
  const Polygon square{{{0, 0}, {10, 0}, {10, 10}, {0, 10}}, {{{4, 4}, {4, 6}, {6, 6}, {6, 4}}}};
  const Region faces = split_by_lines(
      square, {{{4, 4}, {4, -0.001}}, {{4, 6}, {4, 10.001}}, {{6, 4}, {6, -0.001}}, {{6, 6}, {6, 10.001}}});
  EXPECT_EQ(faces.size(), 4u);
  EXPECT_NEAR(area(faces), 96, 1e-9);
}

TEST(Booleans, FindWhereARingCrossesItself) {
  const auto fault = find_invalidity({{{0, 0}, {2, 2}, {2, 0}, {0, 2}}, {}});
  ASSERT_TRUE(fault.has_value());
  EXPECT_NEAR(fault->place.x, 1, 1e-12);
  EXPECT_NEAR(fault->place.y, 1, 1e-12);
  EXPECT_FALSE(find_invalidity(box(0, 0, 1, 1)).has_value());
}

TEST(Booleans, LengthInside) {
  const Polygon square{{{0, 0}, {10, 0}, {10, 10}, {0, 10}}, {{{4, 4}, {4, 6}, {6, 6}, {6, 4}}}};
  EXPECT_NEAR(length_inside({square}, {-5, 5}, {15, 5}), 8, 1e-12);
}

}  // namespace tramline::boolean_test
