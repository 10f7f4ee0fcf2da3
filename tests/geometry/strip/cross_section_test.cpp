#include "tramline/geometry/strip/cross_section.h"

#include <gtest/gtest.h>

namespace tramline {
namespace {

StripGrid grid_of(double origin, double width) {
  return {TrackFrame(Direction::clockwise_from_north(Angle::degrees(0))), origin, width};
}

// A right triangle (0,0) (6,0) (0,12): at x its height is 12 − 2x. In strip [0,3] the cross-section
// is 3 up to y = 6 (where the slope reaches x = 3) and falls linearly to 0 at y = 12.
TEST(CrossSections, OfATriangleFollowItsSlope) {
  const Region triangle{{{{0, 0}, {6, 0}, {0, 12}}, {}}};
  const auto strips = cross_sections(triangle, grid_of(0, 3), {0, 1});
  const auto& first = strips[0].slabs;
  ASSERT_EQ(first.size(), 2u);
  EXPECT_EQ(first[0].from, 0);
  EXPECT_NEAR(first[0].to, 6, 1e-12);
  EXPECT_NEAR(first[0].width_from, 3, 1e-12);
  EXPECT_NEAR(first[0].width_to, 3, 1e-12);
  EXPECT_NEAR(first[1].to, 12, 1e-12);
  EXPECT_NEAR(first[1].width_at(9), 1.5, 1e-12);
  EXPECT_NEAR(area_between(strips[0], 0, 12), 27, 1e-12);  // 3·6 + ½·3·6
  EXPECT_NEAR(area_between(strips[1], 0, 12), 9, 1e-12);   // ½·3·6
  // The centre line x = 1.5 leaves at 12 − 2·1.5 = 9.
  ASSERT_EQ(strips[0].centre_line.size(), 1u);
  EXPECT_NEAR(strips[0].centre_line[0].to, 9, 1e-12);
}

TEST(CrossSections, OfASquareFlushWithTheStripsAreFull) {
  const Region square{{{{0, 0}, {6, 0}, {6, 5}, {0, 5}}, {}}};
  const auto strips = cross_sections(square, grid_of(0, 3), {-1, 2});
  EXPECT_TRUE(strips[0].empty());
  EXPECT_NEAR(area_between(strips[1], 0, 5), 15, 1e-12);
  EXPECT_NEAR(area_between(strips[2], 0, 5), 15, 1e-12);
  EXPECT_NEAR(area_between(strips[3], 0, 5), 0, 1e-12);
  EXPECT_EQ(where_at_least(strips[1], 3).size(), 1u);
}

TEST(CrossSections, SeeAHoleInsideOneStrip) {
  Polygon square{{{0, 0}, {3, 0}, {3, 9}, {0, 9}}, {{{1, 4}, {1, 5}, {2, 5}, {2, 4}}}};
  const auto strips = cross_sections({square}, grid_of(0, 3), {0, 0});
  const Intervals full = where_at_least(strips[0], 3);
  ASSERT_EQ(full.size(), 2u);
  EXPECT_EQ(full[0], (Interval{0, 4}));
  EXPECT_EQ(full[1], (Interval{5, 9}));
  EXPECT_NEAR(area_between(strips[0], 4, 5), 2, 1e-12);
  EXPECT_EQ(where_at_least(strips[0], 2).size(), 1u);
}

// A notch from the side makes two lobes side by side: the cross-section adds up both.
TEST(CrossSections, AddUpLobesSideBySide) {
  const Region u_shape{{{{0, 0}, {3, 0}, {3, 9}, {2, 9}, {2, 4}, {1, 4}, {1, 9}, {0, 9}}, {}}};
  const auto strips = cross_sections(u_shape, grid_of(0, 3), {0, 0});
  EXPECT_NEAR(area_between(strips[0], 0, 9), 3 * 4 + 2 * 5, 1e-12);
  // The centre line runs into the notch at 4.
  ASSERT_EQ(strips[0].centre_line.size(), 1u);
  EXPECT_EQ(strips[0].centre_line[0], (Interval{0, 4}));
}

}  // namespace
}  // namespace tramline
