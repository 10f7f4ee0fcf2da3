#include "tramline/geometry/offset/contour.h"

#include <gtest/gtest.h>

#include "geometry/drivable.h"
#include "geometry/random_shapes.h"

namespace tramline::contour_test {

using testing::RandomCase;

constexpr double kPi = std::numbers::pi;

void expect_at(Point p, Point expected) {
  EXPECT_NEAR(p.x, expected.x, 1e-9);
  EXPECT_NEAR(p.y, expected.y, 1e-9);
}

/// East for 10 m, a quarter of a circle of radius 20 to the left, and north for 5 m.
Path line_arc_line() { return {{{0, 0}, {10, 0}, 0}, {{10, 0}, {30, 20}, 0.05}, {{30, 20}, {30, 25}, 0}}; }

Point place(const Contour& contour, double position, double distance_m) {
  return beside(contour.elements[element_at(contour, position)], position, distance_m);
}

TEST(Contour, RunsAboutALine) {
  const Contour contour = contour_of(straight_path({0, 0}, {10, 0}));
  ASSERT_EQ(contour.elements.size(), 6U) << "two sides and four quarter turns";
  EXPECT_EQ(contour.segments, 1U);
  EXPECT_EQ(contour.right_end(), 10);
  EXPECT_EQ(contour.left_start(), 12);
  EXPECT_EQ(contour.left_end(), 22);
  const double half = std::sqrt(0.5);
  expect_at(place(contour, 3, 2), {3, -2});
  expect_at(place(contour, 10.5, 2), {10 + 2 * half, -2 * half});
  expect_at(place(contour, 11, 2), {12, 0});
  expect_at(place(contour, 11.5, 2), {10 + 2 * half, 2 * half});
  expect_at(place(contour, 15, 2), {7, 2});
  expect_at(place(contour, 22.5, 2), {-2 * half, 2 * half});
  expect_at(place(contour, 24, 2), {0, -2});
}

TEST(Contour, KnowsItsLeftSide) {
  const Contour contour = contour_of(straight_path({0, 0}, {10, 0}));
  EXPECT_FALSE(contour.on_left(0));
  EXPECT_FALSE(contour.on_left(10));
  EXPECT_TRUE(contour.on_left(12));
  EXPECT_TRUE(contour.on_left(22));
}

TEST(Contour, GoesBackAlongTheLeftSideOfAnArc) {
  const Contour contour = contour_of(line_arc_line());
  const double arc = 10 * kPi;
  EXPECT_NEAR(contour.path_length, 15 + arc, 1e-9);
  // The middle of the arc about (10, 20), on the outside of the bend and on its inside.
  const Point outwards{std::sqrt(0.5), -std::sqrt(0.5)}, centre{10, 20};
  expect_at(place(contour, 10 + 0.5 * arc, 3), centre + 23 * outwards);
  expect_at(place(contour, contour.left_start() + 5 + 0.5 * arc, 3), centre + 17 * outwards);
  const ContourElement& back = contour.elements[element_at(contour, contour.left_start() + 5 + 0.5 * arc)];
  expect_at(heading_at(back, contour.left_start() + 5 + 0.5 * arc), {-std::sqrt(0.5), -std::sqrt(0.5)});
}

TEST(Contour, NamesTheEarlierElementWhereTwoMeet) {
  const Contour contour = contour_of(line_arc_line());
  EXPECT_EQ(element_at(contour, 0), 0U);
  EXPECT_EQ(element_at(contour, 10), 0U);
  EXPECT_EQ(element_at(contour, 10.001), 1U);
  EXPECT_EQ(element_at(contour, contour.right_end()), 2U);
  EXPECT_EQ(element_at(contour, contour.right_end() + 0.5), 3U);
  EXPECT_EQ(element_at(contour, contour.left_start() + 0.001), 5U);
  EXPECT_EQ(element_at(contour, contour.left_end()), 7U);
  EXPECT_EQ(element_at(contour, contour.left_end() + 2), 9U);
}

// The inside of the bend is the left side, which is walked backwards and turns to the right.
TEST(Contour, HasNoParallelBeyondTheCentreOfABend) {
  const Contour contour = contour_of(line_arc_line());
  const ContourElement &outside = contour.elements[1], &inside = contour.elements[6];
  EXPECT_TRUE(has_parallel(outside, 1000));
  EXPECT_TRUE(has_parallel(inside, 19.999));
  EXPECT_FALSE(has_parallel(inside, 20));
  EXPECT_FALSE(has_parallel(inside, 21));
  EXPECT_TRUE(has_parallel(contour.elements[0], 1000));
  EXPECT_NEAR(curvature_beside(outside, 5), 1 / 25., 1e-12);
  EXPECT_NEAR(curvature_beside(inside, 5), -1 / 15., 1e-12);
  EXPECT_EQ(curvature_beside(contour.elements[0], 5), 0);
}

TEST(Contour, GivesTheParallelOfASide) {
  const Contour contour = contour_of(line_arc_line());
  Path right, left;
  append_parallel(contour, 0, contour.right_end(), 3, right);
  append_parallel(contour, contour.left_start(), contour.left_end(), 3, left);
  for (const auto& [path, radius] : {std::pair{right, 23.}, {left, 17.}}) {
    ASSERT_EQ(path.size(), 3U);
    expect_drivable(path, radius);
    EXPECT_NEAR(length(path), 15 + radius * kPi / 2, 1e-9);
  }
  expect_at(right.front().from, {0, -3});
  expect_at(right.back().to, {33, 25});
  expect_at(left.front().from, {27, 25});
  expect_at(left.back().to, {0, 3});
  EXPECT_GT(right[1].curvature, 0);
  EXPECT_LT(left[1].curvature, 0);
}

// From 4 m to half of the arc, in two calls that join.
TEST(Contour, GivesPartsOfAParallelThatJoin) {
  const Contour contour = contour_of(line_arc_line());
  Path path;
  append_parallel(contour, 4, 8, 3, path);
  append_parallel(contour, 8, 10 + 5 * kPi, 3, path);
  expect_drivable(path, 23);
  expect_at(path.front().from, {4, -3});
  expect_at(path.back().to, Point{10, 20} + 23 * Point{std::sqrt(0.5), -std::sqrt(0.5)});
  EXPECT_NEAR(length(path), 6 + 23 * kPi / 4, 1e-9);
}

// Beside each position, the path is to the left at the distance asked for, and the heading is that of the way
// on.
TEST(Contour, GoesOnWithoutAKinkAroundRandomPaths) {
  for (int number = 0; number < 100; ++number) {
    RandomCase random(number);
    const Path path = testing::random_smooth_path(random, random.whole(1, 8), 5);
    const Contour contour = contour_of(path);
    const double whole = contour.left_end() + 2, distance_m = random.between(0.1, 4.9);
    for (int i = 0; i < 50; ++i) {
      const double position = random.between(0, whole), step = 1e-5;
      const ContourElement& element = contour.elements[element_at(contour, position)];
      const Point p = beside(element, position, distance_m), heading = heading_at(element, position);
      ASSERT_NEAR(length(heading), 1, 1e-12);
      ASSERT_LT(testing::distance_to(path, p + distance_m * left_of(heading)), 1e-9) << position;
      const Point on = place(contour, std::min(whole, position + step), distance_m) - p;
      ASSERT_GE(dot(on, heading), (1 - 1e-4) * length(on)) << position;
      ASSERT_GT(length(on), 0) << position;
      ASSERT_LT(length(on), 10 * step) << position;
    }
  }
}

TEST(Contour, KeepsAwayWhereNoSegmentIsNearer) {
  int near = 0, away = 0;
  for (int number = 0; number < 200; ++number) {
    RandomCase random(number);
    const Path path = testing::random_smooth_path(random, random.whole(1, 12), 2);
    const Contour contour = contour_of(path);
    const Box window = reach_of(path, 0).grown(30);
    for (int i = 0; i < 50; ++i) {
      const Point p = random.point_in(window);
      const double nearest = testing::distance_to(path, p);
      // As often just inside the distance as just outside it.
      const double distance_m = std::max(0.0, nearest + random.between(-1, 1) * (i % 2 == 0 ? 1e-6 : 10));
      if (std::abs(nearest - distance_m) < 1e-9) continue;
      auto hint = static_cast<std::size_t>(random.whole(0, static_cast<int>(path.size()) - 1));
      const bool keeps = keeps_away(contour, p, distance_m, hint);
      ASSERT_EQ(keeps, nearest > distance_m) << p.x << " " << p.y << " at " << distance_m;
      ++(keeps ? away : near);
      if (keeps) continue;
      ASSERT_LT(hint, contour.elements.size());
      // The far end of the path is looked at for itself.
      if (distance(p, path.back().to) >= distance_m) {
        ASSERT_LT(testing::distance_to(path[hint], p), distance_m + 1e-9);
      }
    }
  }
  EXPECT_GT(near, 2000);
  EXPECT_GT(away, 2000);
}

}  // namespace tramline::contour_test
