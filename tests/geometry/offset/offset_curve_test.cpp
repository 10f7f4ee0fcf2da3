#include "tramline/geometry/offset/offset_curve.h"

#include <gtest/gtest.h>

#include "geometry/random_shapes.h"

namespace tramline::offset_curve_test {

using testing::RandomCase;

constexpr double kPi = std::numbers::pi;

/// About the origin, clockwise between two angles from the x axis.
OffsetCurve arc_about_origin(double radius, double from, double to) {
  return offset_arc({0, 0}, radius, turned({radius, 0}, from), turned({radius, 0}, to));
}

void expect_at(Point p, Point expected) {
  EXPECT_NEAR(p.x, expected.x, 1e-9);
  EXPECT_NEAR(p.y, expected.y, 1e-9);
}

void expect_points(std::vector<Point> found, const std::vector<Point>& expected) {
  ASSERT_EQ(found.size(), expected.size());
  std::sort(found.begin(), found.end(), [](Point a, Point b) { return a.x < b.x; });
  for (std::size_t i = 0; i < expected.size(); ++i) expect_at(found[i], expected[i]);
}

TEST(OffsetCurve, MeasuresALineInMetres) {
  const OffsetCurve line = offset_line({1, 1}, {4, 5});
  EXPECT_TRUE(line.straight());
  EXPECT_NEAR(line.extent, 5, 1e-12);
  EXPECT_EQ(curvature(line), 0);
  expect_at(point_at(line, 2.5), {2.5, 3});
  expect_at(heading_at(line, {2.5, 3}), {0.6, 0.8});
  EXPECT_NEAR(position_on(line, Point{2.5, 3} + Point{-0.8, 0.6}), 2.5, 1e-12) << "at the foot";
  EXPECT_NEAR(position_on(line, {0.4, 0.2}), -1, 1e-12);
}

// From the north over the east: a clock's way.
TEST(OffsetCurve, MeasuresAnArcInRadiansClockwise) {
  const OffsetCurve arc = offset_arc({10, 0}, 2, {10, 2}, {12, 0});
  EXPECT_FALSE(arc.straight());
  EXPECT_NEAR(arc.extent, kPi / 2, 1e-12);
  EXPECT_NEAR(curvature(arc), -0.5, 1e-12);
  expect_at(point_at(arc, 0), {10, 2});
  expect_at(point_at(arc, kPi / 4), {10 + std::sqrt(2), std::sqrt(2)});
  expect_at(point_at(arc, kPi / 2), {12, 0});
  expect_at(heading_at(arc, {10, 2}), {1, 0});
  expect_at(heading_at(arc, {12, 0}), {0, -1});
  EXPECT_NEAR(position_on(arc, {10 + 0.1, 0.1}), kPi / 4, 1e-12) << "on the ray from the centre";
  EXPECT_NEAR(position_on(arc, turned({0, 2}, 0.1) + Point{10, 0}), -0.1, 1e-12) << "just before it";
}

TEST(OffsetCurve, TakesHalfACircle) {
  const OffsetCurve half = arc_about_origin(3, kPi, 0);
  EXPECT_NEAR(half.extent, kPi, 1e-9);
  expect_at(point_at(half, kPi / 2), {0, 3});
  EXPECT_NEAR(half.box.max_y, 3, 1e-6);
  EXPECT_NEAR(half.box.min_y, 0, 1e-6);
}

TEST(OffsetCurve, HasABoxThatFits) {
  for (int number = 0; number < 200; ++number) {
    RandomCase random(number);
    const double from = random.between(-4, 4);
    const OffsetCurve curve = number % 4 == 0
                                  ? offset_line(random.point_in({0, 0, 9, 9}), random.point_in({0, 0, 9, 9}))
                                  : arc_about_origin(5, from, from - random.between(0.01, 3.1));
    Box seen;
    for (int i = 0; i <= 1000; ++i) seen.extend(point_at(curve, curve.extent * i / 1000));
    EXPECT_LE(curve.box.min_x, seen.min_x);
    EXPECT_LE(curve.box.min_y, seen.min_y);
    EXPECT_GE(curve.box.max_x, seen.max_x);
    EXPECT_GE(curve.box.max_y, seen.max_y);
    EXPECT_LT(curve.box.width() - seen.width(), 1e-4);
    EXPECT_LT(curve.box.height() - seen.height(), 1e-4);
  }
}

TEST(OffsetCurveMeetings, OfLines) {
  const OffsetCurve line = offset_line({0, 0}, {10, 0});
  expect_points(meetings(line, offset_line({3, -2}, {5, 2})), {{4, 0}});
  expect_points(meetings(line, offset_line({10, 0}, {12, 7})), {{10, 0}});
  EXPECT_TRUE(meetings(line, offset_line({3, 1}, {5, 2})).empty()) << "the other line ends before";
  EXPECT_TRUE(meetings(line, offset_line({11, -2}, {12, 2})).empty()) << "beyond the end";
  EXPECT_TRUE(meetings(line, offset_line({0, 1e-6}, {10, 1e-6})).empty()) << "beside";
  expect_points(meetings(line, offset_line({7, 0}, {15, 0})), {{7, 0}, {10, 0}});
  expect_points(meetings(line, offset_line({7, 0}, {2, 0})), {{2, 0}, {7, 0}});
  EXPECT_TRUE(meetings(line, offset_line({11, 0}, {15, 0})).empty());
}

// The upper half of the circle of radius 5 about the origin.
TEST(OffsetCurveMeetings, OfALineAndAnArc) {
  const OffsetCurve upper = arc_about_origin(5, kPi, 0);
  expect_points(meetings(upper, offset_line({-9, 3}, {9, 3})), {{-4, 3}, {4, 3}});
  expect_points(meetings(offset_line({9, 3}, {-9, 3}), upper), {{-4, 3}, {4, 3}});
  expect_points(meetings(upper, offset_line({0, 3}, {9, 3})), {{4, 3}});
  expect_points(meetings(upper, offset_line({3, -9}, {3, 9})), {{3, 4}});
  EXPECT_TRUE(meetings(upper, offset_line({-9, -3}, {9, -3})).empty()) << "only the lower half is there";
  EXPECT_TRUE(meetings(upper, offset_line({-9, 5.001}, {9, 5.001})).empty());
  const std::vector<Point> touch = meetings(upper, offset_line({-9, 5}, {9, 5}));
  ASSERT_FALSE(touch.empty());
  for (const Point p : touch) EXPECT_LT(distance(p, {0, 5}), 1e-4);
}

TEST(OffsetCurveMeetings, OfArcs) {
  const OffsetCurve upper = arc_about_origin(5, kPi, 0);
  const OffsetCurve east = offset_arc({6, 0}, 5, {1, 0}, {11, 0});
  expect_points(meetings(upper, east), {{3, 4}});
  const OffsetCurve east_below = offset_arc({6, 0}, 5, {11, 0}, {1, 0});
  EXPECT_TRUE(meetings(upper, east_below).empty()) << "the circles meet at (3, -4) too, but one arc does not";
  const OffsetCurve north = offset_arc({0, 6}, 5, {-5, 6}, {5, 6});
  EXPECT_TRUE(meetings(upper, north).empty());
  const OffsetCurve north_below = offset_arc({0, 6}, 5, {5, 6}, {-5, 6});
  expect_points(meetings(upper, north_below), {{-4, 3}, {4, 3}});
  EXPECT_TRUE(meetings(upper, arc_about_origin(4, kPi, 0)).empty()) << "about one centre";
  expect_points(meetings(upper, arc_about_origin(5, kPi / 2, -0.5)), {{0, 5}, {5, 0}});
}

/// Whether p is on the curve by the definitions of line and circle.
bool holds(const OffsetCurve& curve, Point p) {
  if (curve.straight()) return distance_to_segment(p, curve.from, curve.to) < 1e-8;
  return testing::distance_to(PathSegment{curve.from, curve.to, -1 / curve.radius}, p) < 1e-8;
}

OffsetCurve random_curve(RandomCase& random) {
  const Box window{0, 0, 10, 10};
  if (random.whole(0, 2) == 0) return offset_line(random.point_in(window), random.point_in(window));
  const Point centre = random.point_in(window);
  const double radius = random.between(1, 8), from = random.between(-4, 4);
  return offset_arc(centre, radius, centre + turned({radius, 0}, from),
                    centre + turned({radius, 0}, from - random.between(0.05, 3.1)));
}

/// Places where the two curves, cut into chords, cross.
std::vector<Point> crossings_of_chords(const OffsetCurve& a, const OffsetCurve& b) {
  const auto points = [](const OffsetCurve& curve) {
    std::vector<Point> out;
    const int count = curve.straight() ? 1 : 200;
    for (int i = 0; i <= count; ++i) out.push_back(point_at(curve, curve.extent * i / count));
    return out;
  };
  const std::vector<Point> p = points(a), q = points(b);
  std::vector<Point> out;
  for (std::size_t i = 0; i + 1 < p.size(); ++i)
    for (std::size_t j = 0; j + 1 < q.size(); ++j) {
      const Point u = p[i + 1] - p[i], v = q[j + 1] - q[j];
      const double d = cross(u, v), s = cross(q[j] - p[i], v) / d, t = cross(q[j] - p[i], u) / d;
      if (s >= 0 && s < 1 && t >= 0 && t < 1) out.push_back(p[i] + s * u);
    }
  return out;
}

TEST(OffsetCurveMeetings, AreWhereTheirChordsCross) {
  int met = 0;
  for (int number = 0; number < 1000; ++number) {
    RandomCase random(number);
    const OffsetCurve a = random_curve(random), b = random_curve(random);
    const std::vector<Point> found = meetings(a, b), crossings = crossings_of_chords(a, b);
    for (const Point p : found) EXPECT_TRUE(holds(a, p) && holds(b, p)) << p.x << " " << p.y;
    // Chords may miss an arc that is hardly touched, but never by a pair of crossings that are far apart.
    const bool touch = found.size() == 2 && distance(found[0], found[1]) < 0.5;
    if (!touch) {
      EXPECT_EQ(found.size(), crossings.size());
    }
    for (const Point p : crossings)
      EXPECT_TRUE(std::any_of(found.begin(), found.end(), [p](Point q) { return distance(p, q) < 0.05; }));
    met += static_cast<int>(found.size());
  }
  EXPECT_GT(met, 40);
}

}  // namespace tramline::offset_curve_test
