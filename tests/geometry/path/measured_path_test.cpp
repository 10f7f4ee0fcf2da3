#include "tramline/geometry/path/measured_path.h"

#include <gtest/gtest.h>

#include "geometry/random_shapes.h"

namespace tramline::measured_path_test {

using testing::RandomCase;

constexpr double kPi = std::numbers::pi;

void expect_point(const PathPoint& found, Point at, Point heading) {
  EXPECT_LT(distance(found.at, at), 1e-9);
  EXPECT_LT(distance(found.heading, heading), 1e-9);
}

/// East for 10 m, a quarter of a circle of radius 20 to the left, and north for 5 m.
Path line_arc_line() { return {{{0, 0}, {10, 0}, 0}, {{10, 0}, {30, 20}, 0.05}, {{30, 20}, {30, 25}, 0}}; }

TEST(MeasuredPath, AddsUpItsSegments) {
  const MeasuredPath path(line_arc_line());
  EXPECT_NEAR(path.length(), 15 + 10 * kPi, 1e-9);
  EXPECT_EQ(path.path(), line_arc_line());
}

TEST(MeasuredPath, GivesPointsOnLinesAndArcs) {
  const MeasuredPath path(line_arc_line());
  const double half = std::sqrt(0.5), arc = 10 * kPi;
  expect_point(path.at(0), {0, 0}, {1, 0});
  expect_point(path.at(4), {4, 0}, {1, 0});
  expect_point(path.at(10), {10, 0}, {1, 0});
  expect_point(path.at(10 + 0.5 * arc), Point{10, 20} + 20 * Point{half, -half}, {half, half});
  expect_point(path.at(10 + arc), {30, 20}, {0, 1});
  expect_point(path.at(11 + arc), {30, 21}, {0, 1});
}

TEST(MeasuredPath, TurnsRightAlongAnArcToTheRight) {
  const MeasuredPath path(Path{{{0, 0}, {20, -20}, -0.05}});
  const double half = std::sqrt(0.5);
  expect_point(path.at(5 * kPi), Point{0, -20} + 20 * Point{half, half}, {half, -half});
}

TEST(MeasuredPath, EndsWhereThePathEnds) {
  const MeasuredPath path(line_arc_line());
  expect_point(path.at(-3), {0, 0}, {1, 0});
  expect_point(path.at(1000), {30, 25}, {0, 1});
}

// At a kink the heading is that of the way on.
TEST(MeasuredPath, LooksAheadAtAKink) {
  const MeasuredPath path(Path{{{0, 0}, {10, 0}, 0}, {{10, 0}, {10, 10}, 0}});
  expect_point(path.at(10), {10, 0}, {0, 1});
  expect_point(path.at(9.999), {9.999, 0}, {1, 0});
}

// A metre along is a metre driven, in the direction of the heading.
TEST(MeasuredPath, GoesOnByAsMuchAsIsAskedFor) {
  for (int number = 0; number < 100; ++number) {
    RandomCase random(number);
    const Path smooth = testing::random_smooth_path(random, random.whole(1, 10), 3);
    const MeasuredPath path(smooth);
    double start = 0;
    for (const PathSegment& segment : smooth) {
      EXPECT_LT(distance(path.at(start).at, segment.from), 1e-9);
      start += length(segment);
    }
    for (int i = 0; i < 50; ++i) {
      const double step = 1e-4, along = random.between(0, path.length() - step);
      const PathPoint here = path.at(along);
      EXPECT_LT(testing::distance_to(smooth, here.at), 1e-9);
      // On the way of a step an arc of 3 m leaves its tangent by step² / 6.
      EXPECT_LT(distance(path.at(along + step).at, here.at + step * here.heading), 1e-8);
    }
  }
}

}  // namespace tramline::measured_path_test
