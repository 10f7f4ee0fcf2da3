#include "tramline/geometry/polygon/boolean.h"

#include <gtest/gtest.h>

namespace tramline {
namespace boolean_test {

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

}  // namespace boolean_test
}  // namespace tramline
