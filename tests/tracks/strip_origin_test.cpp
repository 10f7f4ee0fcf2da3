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

// Versleijen §2.2.1: the grid lies on the longest edge parallel to the direction, here the right one.
TEST(StripGrids, LieOnTheLongestParallelEdge) {
  const Subfield trapezium{{{{0, 0}, {40, 0}, {40, 80}, {0, 50}}, {}}, kNorth};
  const auto grids = strip_grids(trapezium, 3);
  ASSERT_EQ(grids.size(), 1u);
  EXPECT_NEAR(off_line(grids[0], 40), 0, 1e-9);
  EXPECT_NEAR(off_line(grids[0], 0), 1, 1e-9);  // 40 = 13·3 + 1
}

TEST(StripGrids, LookAtHolesToo) {
  const Subfield diamond{{{{-50, 0}, {0, -50}, {50, 0}, {0, 50}}, {{{1, -5}, {1, 5}, {3, 5}, {3, -5.5}}}},
                         kNorth};
  EXPECT_NEAR(off_line(strip_grids(diamond, 4).front(), 3), 0, 1e-9);
}

TEST(StripGrids, OfferBothExtremesWithoutAParallelEdge) {
  const Subfield diamond{{{{-50, 0}, {0, -50}, {50, 0}, {0, 50}}, {}}, kNorth};
  const auto grids = strip_grids(diamond, 3);
  ASSERT_EQ(grids.size(), 2u);
  EXPECT_NEAR(off_line(grids[0], -50), 0, 1e-9);
  EXPECT_NEAR(off_line(grids[1], 50), 0, 1e-9);
}

TEST(StripGrids, OfferBothSidesOfARectangleUnlessTheyAreInStep) {
  EXPECT_EQ(strip_grids({{{{0, 0}, {40, 0}, {40, 80}, {0, 80}}, {}}, kNorth}, 3).size(), 2u);
  EXPECT_EQ(strip_grids({{{{0, 0}, {42, 0}, {42, 80}, {0, 80}}, {}}, kNorth}, 3).size(), 1u);
}

TEST(StripGrids, TurnWithTheDirection) {
  const Subfield box{{{{0, 0}, {80, 0}, {80, 42}, {0, 42}}, {}}, Direction::along({0, 0}, {1, 0})};
  const StripGrid grid = strip_grids(box, 3).front();
  EXPECT_NEAR(off_line(grid, grid.frame.to_track(Point{17, 0}).x), 0, 1e-9);
}

}  // namespace
}  // namespace tramline
