#include "tramline/geometry/path/extended_line.h"

#include <gtest/gtest.h>

#include <numbers>

#include "geometry/drivable.h"

namespace tramline {
namespace {

constexpr Box kBox{0, 0, 100, 60};

TEST(Extended, LeavesTheWholeBoxBehind) {
  const Extended out = extended(straight_path({20, 10}, {30, 20}), kBox);
  ASSERT_EQ(out.path.size(), 3u);
  expect_drivable(out.path, 1);
  const Point end = out.path.back().to, begin = out.path.front().from;
  for (const Point corner : {Point{0, 0}, Point{100, 0}, Point{100, 60}, Point{0, 60}}) {
    EXPECT_LE(dot(corner - end, {1, 1}), 1e-9);
    EXPECT_GE(dot(corner - begin, {1, 1}), -1e-9);
  }
  EXPECT_NEAR(end.x + end.y, 160, 1e-9) << "and no more than that";
  EXPECT_FALSE(out.blocked_at_start || out.blocked_at_end);
}

TEST(Extended, AddsNothingOutsideTheBox) {
  EXPECT_EQ(extended(straight_path({-5, 30}, {110, 30}), kBox).path.size(), 1u);
  EXPECT_NEAR(length(extended(straight_path({0, 0}, {10, 0}), 3, 4).path), 17, 1e-12);
}

// Three quarters of a circle about (50, 30): the ends' extensions meet outside it.
TEST(Extended, EndsWhereItMeetsWhatExtendsTheOtherEnd) {
  const Path path{{{60, 30}, {50, 40}, 0.1}, {{50, 40}, {40, 30}, 0.1}, {{40, 30}, {50, 20}, 0.1}};
  const Extended out = extended(path, kBox);
  EXPECT_FALSE(out.blocked_at_start);
  EXPECT_TRUE(out.blocked_at_end);
  EXPECT_NEAR(distance(out.path.back().to, {60, 20}), 0, 1e-9);
}

// Lines that end on the border of a box but for rounding: a segment of no length would have no heading.
TEST(Extended, HasNoSegmentsWithoutADirection) {
  const Path path{{{0, 50}, {100, 50}, 0}};
  for (const double by_m : {0.0, 4e-16, 2e-14, 1e-10}) {
    const Extended out = extended(path, by_m, by_m);
    EXPECT_EQ(out.path, path) << by_m;
  }
  EXPECT_EQ(extended(path, 1, 1).path.size(), 3U);
}

// A hook whose end points at its own shaft.
TEST(Extended, EndsWhereItMeetsThePath) {
  const Path path{{{10, 30}, {60, 30}, 0}, {{60, 30}, {60, 50}, 0.1}, {{60, 50}, {50, 40}, 0.1}};
  const Extended out = extended(path, kBox);
  EXPECT_FALSE(out.blocked_at_start);
  EXPECT_TRUE(out.blocked_at_end);
  EXPECT_NEAR(distance(out.path.back().to, {50, 30}), 0, 1e-9);
}

}  // namespace
}  // namespace tramline
