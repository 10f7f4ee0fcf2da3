// Which side of a detour things are on, and how near to the line that it left, along lines of every shape.

#include "tramline/check/measure/detour_course.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "check/plans.h"
#include "tramline/check/lines/track_line.h"

namespace tramline {
namespace {

using namespace testing_plans;
using check::DetourCourse;
using check::Sides;

constexpr double kNowhere = std::numeric_limits<double>::infinity();

Polygon pole(Point at) { return {box(at.x - 0.25, at.y - 0.25, at.x + 0.25, at.y + 0.25), {}}; }

void expect_sides(const Sides& sides, double left_m, double right_m) {
  if (std::isinf(left_m))
    EXPECT_EQ(sides.left_m, left_m);
  else
    EXPECT_NEAR(sides.left_m, left_m, 1e-9);
  if (std::isinf(right_m))
    EXPECT_EQ(sides.right_m, right_m);
  else
    EXPECT_NEAR(sides.right_m, right_m, 1e-9);
}

/// East along y = 0 from x = 0 to 40; the detour leaves it by 3 m on its left between 10 and 30.
DetourCourse straight_course() {
  return {straight_path({0, 0}, {40, 0}),
          {{{0, 0}, {10, 3}, 0}, {{10, 3}, {30, 3}, 0}, {{30, 3}, {40, 0}, 0}}};
}

TEST(DetourCourse, TellsTheSidesOfAStraightLine) {
  const DetourCourse course = straight_course();
  EXPECT_TRUE(course.goes_left());
  expect_sides(course.sides_of(pole({20, 0})), kNowhere, 0);  // on the line, and so on the detour's right
  expect_sides(course.sides_of(pole({20, 2})), kNowhere, 1.75);
  expect_sides(course.sides_of(pole({20, -2})), kNowhere, 1.75);
  expect_sides(course.sides_of(pole({20, 5})), 4.75, kNowhere);
  expect_sides(course.sides_of(pole({-1, 0})), kNowhere, kNowhere);  // beyond its end
  EXPECT_NEAR(course.distance_to_line(pole({-1, 0})), 0.75, 1e-12);
  expect_sides(course.sides_of({box(-5, -5, 45, 45), {}}), 0, 0);  // all about it
}

TEST(DetourCourse, IsMirroredInTheLine) {
  const DetourCourse course(straight_path({0, 0}, {40, 0}),
                            {{{0, 0}, {10, -3}, 0}, {{10, -3}, {30, -3}, 0}, {{30, -3}, {40, 0}, 0}});
  EXPECT_FALSE(course.goes_left());
  expect_sides(course.sides_of(pole({20, 0})), 0, kNowhere);
  expect_sides(course.sides_of(pole({20, -5})), kNowhere, 4.75);
}

/// Half a circle of 20 m anticlockwise about the origin, from east by north to west; the detour goes round it
/// at 23 m, on the right, or at 17 m.
DetourCourse round_course(double radius_m) {
  const Path line{{{20, 0}, {0, 20}, 0.05}, {{0, 20}, {-20, 0}, 0.05}};
  return {line,
          {{{20, 0}, {radius_m, 0}, 0},
           {{radius_m, 0}, {-radius_m, 0}, 1 / radius_m},
           {{-radius_m, 0}, {-20, 0}, 0}}};
}

TEST(DetourCourse, TellsTheSidesOfACurve) {
  const DetourCourse outside = round_course(23), inside = round_course(17);
  EXPECT_FALSE(outside.goes_left());
  EXPECT_TRUE(inside.goes_left());
  const double nearest = 21.75;  // of a pole 22 m north, whose corners are farther from the origin
  expect_sides(outside.sides_of(pole({0, 22})), nearest - 20, kNowhere);
  expect_sides(inside.sides_of(pole({0, 22})), kNowhere, nearest - 20);
  expect_sides(outside.sides_of(pole({0, 20})), 0, kNowhere);
  expect_sides(inside.sides_of(pole({0, 20})), kNowhere, 0);
  expect_sides(outside.sides_of(pole({0, 25})), kNowhere, 24.75 - 20);
  // South of both ends, across from no place of the half circle.
  expect_sides(outside.sides_of(pole({20, -1})), kNowhere, kNowhere);
  EXPECT_NEAR(outside.distance_to_line(pole({20, -1})), 0.75, 1e-9);
}

TEST(TrackLine, StraightOnesLeadBothWays) {
  const check::TrackLine line(check::StraightLine({3, 4}, {0.6, 0.8}));
  EXPECT_FALSE(line.may_close());
  const Point from{6, 8}, to{9, 12};
  // Which way it is left in does not matter; being off it by more than a millimetre does.
  for (const Point heading : {Point{1, 0}, Point{-1, 0}}) {
    const auto path = line.between(from, heading, to), back = line.between(to, heading, from);
    ASSERT_TRUE(path && back);
    EXPECT_NEAR(length(*path), 5, 1e-12);
    EXPECT_EQ(*back, reversed(*path));
  }
  EXPECT_TRUE(line.position_of(from + 0.0009 * Point{0.8, -0.6}));
  EXPECT_FALSE(line.position_of(from + 0.0011 * Point{0.8, -0.6}));
  EXPECT_FALSE(line.position_of({std::nan(""), 0}));
  EXPECT_FALSE(line.between(from, {1, 0}, from));
}

}  // namespace
}  // namespace tramline
