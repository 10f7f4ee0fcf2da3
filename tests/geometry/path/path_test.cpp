#include "tramline/geometry/path/path.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>

#include "tramline/geometry/polygon/boolean.h"

namespace tramline::path_test {

constexpr double kPi = std::numbers::pi;

// A quarter turn to the left of radius 2 from the origin heading north ends at (−2, 2).
const PathSegment kQuarterLeft{{0, 0}, {-2, 2}, 0.5};

void expect_near(Point p, Point q, double tolerance = 1e-12) {
  EXPECT_NEAR(p.x, q.x, tolerance);
  EXPECT_NEAR(p.y, q.y, tolerance);
}

TEST(Path, KnowsTheParametersOfAQuarterTurn) {
  expect_near(centre(kQuarterLeft), {-2, 0});
  EXPECT_NEAR(turning(kQuarterLeft), kPi / 2, 1e-12);
  EXPECT_NEAR(length(kQuarterLeft), kPi, 1e-12);
  expect_near(direction_at_start(kQuarterLeft), {0, 1});
  expect_near(direction_at_end(kQuarterLeft), {-1, 0});
}

TEST(Path, TurnsRightWithNegativeCurvature) {
  const PathSegment right{{0, 0}, {2, 2}, -0.5};
  expect_near(centre(right), {2, 0});
  EXPECT_NEAR(turning(right), -kPi / 2, 1e-12);
  expect_near(direction_at_end(right), {1, 0});
}

TEST(Path, ReversedDrivesTheSameGroundBackwards) {
  const Path path{{{0, -3}, {0, 0}, 0}, kQuarterLeft};
  const Path back = reversed(path);
  EXPECT_EQ(back.front().from, Point(-2, 2));
  EXPECT_EQ(back.back().to, Point(0, -3));
  expect_near(centre(back.front()), {-2, 0});
  expect_near(direction_at_end(back.front()), {0, -1});
  EXPECT_NEAR(length(back), 3 + kPi, 1e-12);
}

TEST(Path, ChordsStayWithinTheSagitta) {
  for (const double sagitta : {0.1, 1e-3, 1e-5}) {
    const std::vector<Point> line = chords({kQuarterLeft}, sagitta);
    EXPECT_EQ(line.front(), kQuarterLeft.from);
    EXPECT_EQ(line.back(), kQuarterLeft.to);
    for (std::size_t i = 0; i + 1 < line.size(); ++i) {
      EXPECT_NEAR(distance(line[i], {-2, 0}), 2, 1e-12);
      EXPECT_LE(2 - distance(midpoint(line[i], line[i + 1]), {-2, 0}), sagitta * (1 + 1e-9));
    }
  }
}

// An S of two quarter turns and a line: width times length, to what the chords leave out.
TEST(Path, ABandHasTheAreaOfItsWidthTimesLength) {
  const Path path{{{0, -3}, {0, 0}, 0}, kQuarterLeft, {{-2, 2}, {-4, 4}, -0.5}, {{-4, 4}, {-4, 9}, 0}};
  for (const double width : {0.5, 2.0, 4.0}) {
    const Ring ring = band(path, width);
    EXPECT_FALSE(find_invalidity({ring, {}}));
    EXPECT_GT(signed_area(ring), 0);
    EXPECT_NEAR(signed_area(ring), width * length(path), 2 * kChordSagitta * length(path));
  }
}

TEST(Path, MeasuresTheDistanceFromAnArcToAnEdge) {
  // Beyond the arc, inside it, through it, and off its end.
  EXPECT_NEAR(distance_to_edge(kQuarterLeft, {3, -1}, {3, 5}), 3, 1e-12);
  EXPECT_NEAR(distance_to_edge(kQuarterLeft, {-2, 0}, {-1.5, 0}), 1.5, 1e-12);
  EXPECT_EQ(distance_to_edge(kQuarterLeft, {-2, 0}, {2, 4}), 0);
  EXPECT_NEAR(distance_to_edge(kQuarterLeft, {-4, -2}, {4, -2}), 2, 1e-12);
  // A line at 45 degrees 3 m from the centre: 1 m from the arc's middle.
  const double k = 3 / std::sqrt(2.0);
  EXPECT_NEAR(distance_to_edge(kQuarterLeft, {-2 + k - 5, k + 5}, {-2 + k + 5, k - 5}), 1, 1e-12);
}

// The oracle: the distance between the edge and fine chords.
TEST(Path, DistancesAgreeWithThoseOfChords) {
  for (int i = 0; i < 400; ++i) {
    const double t = 0.7 * i;
    const Point a{5 * std::sin(t), 4 * std::cos(1.3 * t)}, b{a.x + 3 * std::cos(2.1 * t), a.y + std::sin(t)};
    const PathSegment arc{{0, 0}, {std::sin(0.9 * t), 1.5 + std::cos(t)}, 0.6 * std::cos(0.37 * t)};
    const std::vector<Point> line = chords({arc}, 1e-7);
    double nearest = 1e9;
    for (std::size_t j = 0; j + 1 < line.size(); ++j)
      nearest = std::min(nearest, distance_to_edge({line[j], line[j + 1], 0}, a, b));
    EXPECT_NEAR(distance_to_edge(arc, a, b), nearest, 2e-6) << i;
  }
}

TEST(Path, FindsItsSmallestRadius) {
  EXPECT_EQ(smallest_radius(straight_path({0, 0}, {1, 0})), std::numeric_limits<double>::infinity());
  EXPECT_NEAR(smallest_radius({{{0, -3}, {0, 0}, 0}, kQuarterLeft}), 2, 1e-12);
}

/// Round a square, driven at half the width from it: inwards of its arcs there is but a corner, or by
/// rounding a loop of a few nanometres either way round.
TEST(Path, ABandRoundCornersAsTightAsItselfIsARing) {
  const double width = 36, side = 70;
  const double aslant = 0.3;
  std::array<Point, 4> corners;
  std::array<Point, 5> outwards;
  for (std::size_t i = 0; i < 5; ++i)
    outwards[i] = turned({0, -1}, aslant + 0.5 * kPi * static_cast<double>(i));
  for (std::size_t i = 0; i < 4; ++i)
    corners[i] = Point{-228, -404} + 0.5 * side * (outwards[i] + outwards[(i + 3) % 4]);
  for (const double off_m : {-2e-7, -2e-8, -5e-9, 0.0, 5e-9, 2e-8, 2e-7}) {
    SCOPED_TRACE(off_m);
    const double reach_m = 0.5 * width + off_m;
    Path round;
    for (std::size_t i = 0; i < corners.size(); ++i) {
      const Point next = corners[(i + 1) % corners.size()];
      const Point begins = next + reach_m * outwards[i], ends = next + reach_m * outwards[i + 1];
      round.push_back({corners[i] + reach_m * outwards[i], begins, 0});
      round.push_back({begins, ends, 1 / reach_m});
    }
    const Polygon ring = closed_band(round, width);
    EXPECT_FALSE(find_invalidity(ring));
    EXPECT_NEAR(area({ring}), 4 * side * width + kPi * width * width, 1);
    EXPECT_NEAR(area(intersection({ring}, {{{corners.begin(), corners.end()}, {}}})), 0, 1e-3);
  }
}

}  // namespace tramline::path_test
