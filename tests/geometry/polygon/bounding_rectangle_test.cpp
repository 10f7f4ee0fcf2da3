#include "tramline/geometry/polygon/bounding_rectangle.h"

#include <gtest/gtest.h>

namespace tramline {
namespace {

TEST(SmallestRectangle, OfARectangleIsItself) {
  EXPECT_NEAR(long_side_of_smallest_rectangle({{0, 0}, {10, 0}, {10, 4}, {0, 4}}).degrees(), 90, 1e-9);
  EXPECT_NEAR(long_side_of_smallest_rectangle({{0, 0}, {4, 0}, {4, 10}, {0, 10}}).degrees(), 0, 1e-9);
}

// Kite (0,0) (8,−3) (10,0) (8,3). Rectangle on an edge of the long sides, e.g. (0,0)→(8,3):
// area (|p·u| range)·(altitude); on the axis it is 10 × 6 = 60. For the edge of length √73 the range
// along it is 80/√73 and the altitude of (8,−3) is 48/√73: 3840/73 = 52.6 < 60. The least width is
// 48/√73 = 5.62 < 6 as well. The two long edges tie: the smaller direction, atan2(8, 3), wins.
TEST(SmallestRectangle, OfAKiteLiesOnALongEdge) {
  const Ring kite{{0, 0}, {8, -3}, {10, 0}, {8, 3}};
  const double expected = std::atan2(8, 3) * 180 / std::numbers::pi;
  EXPECT_NEAR(long_side_of_smallest_rectangle(kite).degrees(), expected, 1e-9);
  EXPECT_NEAR(across_least_width(kite).degrees(), expected, 1e-9);
}

// Versleijen §2.2.1: the smallest rectangle is not always across the least width. Triangle (0,0) (10,0)
// (5,9): every rectangle on an edge has area 2·45 = 90, so they tie; altitudes are 9 on the base and
// 90/√106 = 8.74 on the sides.
TEST(LeastWidth, OfATriangleIsItsLeastAltitude) {
  const Direction direction = across_least_width({{0, 0}, {10, 0}, {5, 9}});
  const double side = std::atan2(5, 9) * 180 / std::numbers::pi;
  EXPECT_TRUE(std::abs(direction.degrees() - side) < 1e-9 ||
              std::abs(direction.degrees() - (180 - side)) < 1e-9);
}

// Legs of 10 and 4: rectangles on all three edges have 40 m². On the long leg it is 10 × 4, on the
// hypotenuse (√116 = 10.77) 40/10.77 = 3.71 wide: the slimmest, in whichever frame.
TEST(SmallestRectangle, OfATriangleIsTheSlimmestOfThree) {
  const double hypotenuse = 90 + std::atan2(4, 10) * 180 / std::numbers::pi;
  EXPECT_NEAR(long_side_of_smallest_rectangle({{0, 0}, {10, 0}, {0, 4}}).degrees(), hypotenuse, 1e-9);
  EXPECT_NEAR(long_side_of_smallest_rectangle({{0, 0}, {0, 10}, {-4, 0}}).degrees(), hypotenuse - 90, 1e-9);
}

TEST(Hull, DropsInnerAndCollinearPoints) {
  const Ring hull = hull_of({{0, 0}, {2, 0}, {4, 0}, {4, 4}, {1, 1}, {0, 4}});
  EXPECT_EQ(hull.size(), 4u);
  EXPECT_NEAR(signed_area(hull), 16, 1e-12);
}

}  // namespace
}  // namespace tramline
