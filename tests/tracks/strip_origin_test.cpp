#include "tramline/tracks/strip_origin.h"

#include <gtest/gtest.h>

namespace tramline {
namespace {

const Direction kNorth = Direction::clockwise_from_north(Angle::degrees(0));

/// How far a coordinate across lies from the nearest strip line.
double off_line(const StripGrid& grid, double across) {
  const double strips = (across - grid.origin_m) / grid.width_m;
  return std::abs(strips - std::round(strips)) * grid.width_m;
}

// S1.13: the grid lies on the longest edge parallel to the direction, here the right one.
TEST(StripGrid, LiesOnTheLongestParallelEdge) {
  const Subfield trapezium{{{{0, 0}, {40, 0}, {40, 80}, {0, 50}}, {}}, kNorth};
  EXPECT_NEAR(off_line(strip_grid(trapezium, 3), 40), 0, 1e-9);
  EXPECT_NEAR(off_line(strip_grid(trapezium, 3), 0), 1, 1e-9);  // 40 = 13·3 + 1
}

TEST(StripGrid, LooksAtHolesToo) {
  const Subfield diamond{{{{-50, 0}, {0, -50}, {50, 0}, {0, 50}}, {{{1, -5}, {1, 5}, {3, 5}, {3, -5.5}}}}, kNorth};
  EXPECT_NEAR(off_line(strip_grid(diamond, 4), 3), 0, 1e-9);
}

TEST(StripGrid, StartsAtTheLeftWithoutAParallelEdge) {
  const Subfield diamond{{{{-50, 0}, {0, -50}, {50, 0}, {0, 50}}, {}}, kNorth};
  EXPECT_NEAR(off_line(strip_grid(diamond, 3), -50), 0, 1e-9);
}

TEST(StripGrid, TurnsWithTheDirection) {
  const Subfield box{{{{0, 0}, {80, 0}, {80, 40}, {0, 40}}, {}}, Direction::along({0, 0}, {1, 0})};
  const StripGrid grid = strip_grid(box, 3);
  const Point on_edge = grid.frame.to_track(Point{17, 0});
  EXPECT_NEAR(off_line(grid, on_edge.x), 0, 1e-9);
}

}  // namespace
}  // namespace tramline
