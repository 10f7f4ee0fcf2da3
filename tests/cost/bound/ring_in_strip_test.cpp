// What strips hold of a ring, by hand.

#include "tramline/cost/bound/ring_in_strip.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace tramline {
namespace {

bool is_empty(const Interval& rows) { return rows.from > rows.to; }

// A gable: 10 m wide, its walls 4 m high and its ridge 8 m, in the middle.
Ring gable() { return {{0, 0}, {10, 0}, {10, 4}, {5, 8}, {0, 4}}; }

TEST(ExtentAlong, IsOfThePartBetweenTheLines) {
  const Interval at_the_wall = extent_along(gable(), 0, 2.5), all = extent_along(gable(), -3, 13);
  EXPECT_DOUBLE_EQ(at_the_wall.from, 0);
  EXPECT_DOUBLE_EQ(at_the_wall.to, 6);
  EXPECT_DOUBLE_EQ(all.from, 0);
  EXPECT_DOUBLE_EQ(all.to, 8);
}

TEST(ExtentAlong, IsEmptyBesideTheRing) {
  EXPECT_TRUE(is_empty(extent_along(gable(), 11, 14)));
  EXPECT_TRUE(is_empty(extent_along(gable(), -9, -1)));
}

// A strip that may lie anywhere within more than its width has nothing between its lines for sure, however
// much of the ring is there.
TEST(ExtentAlong, IsEmptyBetweenLinesThatHaveCrossed) { EXPECT_TRUE(is_empty(extent_along(gable(), 6, 4))); }

// Of rows 1 m to 6 m both ends of both walls and of both halves of the roof; the floor lies below.
TEST(CornersIn, AreThoseInTheRowsAndWhereTheRingEntersThem) {
  const std::vector<Point> low = corners_in(gable(), {1, 6}), high = corners_in(gable(), {6, 7});
  ASSERT_EQ(low.size(), 8U);
  for (const Point p : low)
    EXPECT_DOUBLE_EQ(std::abs(p.x - 5), p.y <= 4 ? 5 : 2.5) << "at " << p.y << " m on a wall or the roof";
  ASSERT_EQ(high.size(), 4U);
  for (const Point p : high) EXPECT_DOUBLE_EQ(std::abs(p.x - 5), p.y == 6 ? 2.5 : 1.25);
}

}  // namespace
}  // namespace tramline
