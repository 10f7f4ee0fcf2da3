#include "tramline/geometry/offset/offset_front.h"

#include <gtest/gtest.h>

#include "geometry/random_shapes.h"
#include "tramline/geometry/path/smoothed_line.h"

namespace tramline::offset_front_test {

using testing::RandomCase;

void expect_feet(const Intervals& feet, const Intervals& expected) {
  ASSERT_EQ(feet.size(), expected.size());
  for (std::size_t i = 0; i < feet.size(); ++i) {
    EXPECT_NEAR(feet[i].from, expected[i].from, 1e-6) << i;
    EXPECT_NEAR(feet[i].to, expected[i].to, 1e-6) << i;
  }
}

TEST(OffsetFront, OfALineHasFeetAllAlongTheSidesAskedFor) {
  const Contour contour = contour_of(straight_path({0, 0}, {10, 0}));
  for (const double distance_m : {0.5, 40.0}) {
    expect_feet(offset_front(contour, distance_m, Sides::kRight).feet, {{0, 10}});
    expect_feet(offset_front(contour, distance_m, Sides::kLeft).feet, {{12, 22}});
    expect_feet(offset_front(contour, distance_m, Sides::kBoth).feet, {{0, 10}, {12, 22}});
    EXPECT_TRUE(offset_front(contour, distance_m, Sides::kBoth).corners.empty());
  }
}

// Inside a kink the fronts meet on the bisector, t·tan(τ/2) before the vertex and after it.
TEST(OffsetFront, HasACornerOnTheBisectorOfAKink) {
  const double leg = 100;
  for (const double turn : {0.4, 1.0, 2.0}) {
    const Path path = smoothed({{-leg, 0}, {0, 0}, leg * Point{std::cos(turn), std::sin(turn)}}, 6).path;
    const Contour contour = contour_of(path);
    for (const double t : {7.0, 15.0, 30.0}) {
      const double cut = t * std::tan(0.5 * turn);
      const OffsetFront front = offset_front(contour, t, Sides::kLeft);
      const Interval last_leg{contour.left_start(), contour.left_start() + leg - cut};
      const Interval first_leg{contour.left_end() - leg + cut, contour.left_end()};
      expect_feet(front.feet, {last_leg, first_leg});
      ASSERT_EQ(front.corners.size(), 1U);
      const OffsetCorner& corner = front.corners.front();
      EXPECT_NEAR(corner.before, last_leg.to, 1e-6);
      EXPECT_NEAR(corner.after, first_leg.from, 1e-6);
      EXPECT_NEAR(corner.turn_rad, turn, 1e-6);
      EXPECT_LT(distance(corner.point, {-cut, t}), 1e-6);
      expect_feet(offset_front(contour, t, Sides::kRight).feet, {{0, contour.right_end()}});
    }
  }
}

// Two legs 20 m apart, joined by half a circle at their lower ends: the inside is all within 10 m.
TEST(OffsetFront, EndsWhereTheInsideIsUsedUp) {
  const Path path{
      {{-10, 50}, {-10, 0}, 0}, {{-10, 0}, {0, -10}, 0.1}, {{0, -10}, {10, 0}, 0.1}, {{10, 0}, {10, 50}, 0}};
  const Contour contour = contour_of(path);
  const OffsetFront inside = offset_front(contour, 9.9, Sides::kLeft);
  expect_feet(inside.feet, {{contour.left_start(), contour.left_end()}});
  EXPECT_TRUE(inside.corners.empty());
  EXPECT_TRUE(offset_front(contour, 10.1, Sides::kLeft).feet.empty());
  expect_feet(offset_front(contour, 10.1, Sides::kRight).feet, {{0, contour.right_end()}});
}

bool crosses_itself(const Path& path) {
  const std::vector<Point> line = chords(path, 1e-2);
  for (std::size_t i = 0; i + 1 < line.size(); ++i)
    for (std::size_t j = i + 2; j + 1 < line.size(); ++j) {
      const Point u = line[i + 1] - line[i], v = line[j + 1] - line[j], between = line[j] - line[i];
      const double d = cross(u, v), s = cross(between, v) / d, t = cross(between, u) / d;
      if (s >= -0.01 && s <= 1.01 && t >= -0.01 && t <= 1.01) return true;
    }
  return false;
}

bool has(const Intervals& feet, double position) {
  return std::any_of(feet.begin(), feet.end(),
                     [position](const Interval& i) { return i.from <= position && position <= i.to; });
}

// The definition, asked at one position after the other.
TEST(OffsetFront, HasFeetWhereTheNormalComesNoNearerToThePath) {
  int inside = 0, outside = 0, corners = 0;
  for (int number = 0; number < 300; ++number) {
    RandomCase random(number);
    const Path path = testing::random_smooth_path(random, random.whole(1, 8), 4);
    if (crosses_itself(path)) continue;
    const Contour contour = contour_of(path);
    const double t = random.between(0.5, 40);
    const OffsetFront front = offset_front(contour, t, Sides::kBoth);
    for (int i = 0; i < 200; ++i) {
      const double along = random.between(0, contour.path_length);
      const double position = i % 2 == 0 ? along : contour.left_start() + along;
      const ContourElement& element = contour.elements[element_at(contour, position)];
      const Point p = beside(element, position, t);
      const double short_by = t - testing::distance_to(path, p);
      if (short_by > 1e-8 && short_by < 1e-5) continue;  // too near to the end of a foot to tell
      ASSERT_EQ(has(front.feet, position), short_by <= 1e-8) << position << " at " << t << ": " << short_by;
      ++(short_by <= 1e-8 ? inside : outside);
    }
    for (const OffsetCorner& corner : front.corners) {
      EXPECT_NEAR(testing::distance_to(path, corner.point), t, 2e-5);
      EXPECT_GE(corner.turn_rad, 0);
      EXPECT_LE(corner.turn_rad, std::numbers::pi);
      for (const double position : {corner.before, corner.after}) {
        const ContourElement& element = contour.elements[element_at(contour, position)];
        EXPECT_LT(distance(beside(element, position, t), corner.point), 2e-5) << position;
      }
      ++corners;
    }
  }
  EXPECT_GT(inside, 2000);
  EXPECT_GT(outside, 2000);
  EXPECT_GT(corners, 20);
}

TEST(OffsetFront, OfBothSidesHoldsThatOfEach) {
  for (int number = 0; number < 50; ++number) {
    RandomCase random(number);
    const Path path = testing::random_smooth_path(random, random.whole(1, 6), 4);
    const Contour contour = contour_of(path);
    const double t = random.between(0.5, 30);
    Intervals each = offset_front(contour, t, Sides::kRight).feet;
    for (const Interval& feet : each) EXPECT_LE(feet.to, contour.right_end());
    for (const Interval& feet : offset_front(contour, t, Sides::kLeft).feet) {
      EXPECT_GE(feet.from, contour.left_start());
      each.push_back(feet);
    }
    expect_feet(offset_front(contour, t, Sides::kBoth).feet, each);
  }
}

}  // namespace tramline::offset_front_test
