#include "tramline/geometry/path/kinked_line.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "tramline/geometry/path/kinked_offset.h"
#include "tramline/geometry/polygon/boolean.h"

namespace tramline::kinked_line_test {

constexpr double kPi = std::numbers::pi;

/// East for 100 m, then 100 m turned to the left.
std::vector<Point> bend(double turn_rad) {
  return {{-100, 0}, {0, 0}, {100 * std::cos(turn_rad), 100 * std::sin(turn_rad)}};
}

double length_of(const std::vector<Point>& line) { return length(polyline_path(line)); }

double off(const std::vector<Point>& line, Point p) {
  double least = 1e9;
  for (const PathSegment& segment : polyline_path(line))
    least = std::min(least, distance_to_edge(segment, p, p));
  return least;
}

// A mitre adds d·tan(τ/2) to both edges outside, and takes as much inside.
TEST(KinkedOffset, IsLongerOutsideAndShorterInside) {
  for (const double turn : {0.1, 0.7, 1.5, 2.0})
    for (const double d : {2.0, 15.0}) {
      const double more = 2 * d * std::tan(0.5 * turn);
      EXPECT_NEAR(length_of(kinked_offset(bend(turn), d)), 200 + more, 1e-9) << turn;
      EXPECT_NEAR(length_of(kinked_offset(bend(turn), -d)), 200 - more, 1e-9) << turn;
    }
}

// 150°: mitres would reach 3.9 d; an edge of its own is as far away as all others.
TEST(KinkedOffset, CutsSharpCorners) {
  const std::vector<Point> line = bend(150 * kPi / 180), out = kinked_offset(line, 10);
  ASSERT_EQ(out.size(), 4u);
  for (const Point p : out) {
    EXPECT_GE(off(line, p), 10 - 1e-9);
    EXPECT_LE(off(line, p), 10 / std::cos(37.5 * kPi / 180) + 1e-9);
  }
  EXPECT_NEAR(off(line, midpoint(out[1], out[2])), 10, 1e-9);
}

// An edge of 2 m between two turns of 45° is gone 2/(2·tan 22.5°) = 2.41 m to the inside; from there on the
// edges beside it meet at a right angle.
TEST(KinkedOffset, LeavesOutEdgesThatVanish) {
  const double leg = std::sqrt(2.0);
  const std::vector<Point> line{{0, 0}, {50, 0}, {50 + leg, -leg}, {50 + leg, -80}};
  EXPECT_EQ(kinked_offset(line, 2.4).size(), 4u);
  const std::vector<Point> out = kinked_offset(line, 5);
  ASSERT_EQ(out.size(), 3u);
  EXPECT_NEAR(out[1].x, 50 + leg - 5, 1e-9);
  EXPECT_NEAR(out[1].y, -5, 1e-9);
}

// A bottle with a neck of 10 m: 6 m inwards the neck is shut. What runs on inside the bottle is lost.
TEST(KinkedOffset, LosesLobes) {
  const std::vector<Point> line{{-60, 0}, {-5, 0}, {-20, -30}, {20, -30}, {5, 0}, {60, 0}};
  const std::vector<Point> out = kinked_offset(line, -6);
  ASSERT_GE(out.size(), 2u);
  for (const Point p : out) EXPECT_NEAR(p.y, 6, 1e-9);
  EXPECT_NEAR(out.front().x, -60, 1e-9);
  EXPECT_NEAR(out.back().x, 60, 1e-9);
  EXPECT_NEAR(length_of(out), 120, 1e-9);
}

TEST(KinkedLine, KnowsKinks) {
  EXPECT_FALSE(has_kinks(straight_path({0, 0}, {5, 5})));
  EXPECT_FALSE(has_kinks(polyline_path({{0, 0}, {5, 5}, {8, 8}})));
  EXPECT_FALSE(has_kinks({{{100, 0}, {0, 100}, 0.01}}));
  EXPECT_TRUE(has_kinks(polyline_path({{0, 0}, {5, 5}, {8, 8.1}})));
  EXPECT_TRUE(has_kinks(polyline_path({{0, 0}, {5, 0}, {0, 0}})));
  EXPECT_FALSE(has_kinks(polyline_path({{0, 0}, {1e-6, 1e-14}, {25, 0}}))) << "rounding, 1e-8 rad";
  EXPECT_TRUE(has_kinks(polyline_path({{0, 0}, {1e-6, 1e-6}, {25, 0}})));
}

// One kink: together the mitred band, of the area w·L; the flat bands of its legs lack the kite outside.
TEST(KinkedLine, CellsOfOneKinkAreTheMitredBand) {
  const double turn = 1.2, half = 3;
  const Path path = polyline_path(bend(turn));
  Region cells;
  for (const Ring& cell : kinked_cells(path, 2 * half)) cells.push_back({cell, {}});
  ASSERT_EQ(cells.size(), 2u);
  const Region both = unite(cells);
  EXPECT_NEAR(area(both), 2 * half * 200, 1e-3);
  EXPECT_NEAR(area(symmetric_difference(both, {{kinked_band(path, 2 * half), {}}})), 0, 1e-3);
  const Region flat = unite({{band({path[0]}, 2 * half), {}}, {band({path[1]}, 2 * half), {}}});
  EXPECT_NEAR(area(difference(both, flat)), half * half * std::tan(0.5 * turn), 1e-3);
}

// Beyond 120°, and where a leg is too short for its mitre, ends are flat: the legs lie over one another.
TEST(KinkedLine, CellsHaveFlatEndsAtSharpKinksAndShortLegs) {
  for (const Path& path : {polyline_path(bend(2.5)), polyline_path({{-100, 0}, {0, 0}, {0, 2.9}})}) {
    const std::vector<Ring> cells = kinked_cells(path, 6);
    for (std::size_t i = 0; i < 2; ++i)
      EXPECT_NEAR(area(symmetric_difference({{cells[i], {}}}, {{band({path[i]}, 6), {}}})), 0, 1e-4);
  }
}

// The tangent of half such a turn is a quotient of two roundings: whatever it comes out as, ends are flat.
TEST(KinkedLine, ALineThatGoesStraightBackHasFlatEnds) {
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> place(-100, 100);
  for (int i = 0; i < 1000; ++i) {
    const Point a{place(random), place(random)}, b{place(random), place(random)};
    for (const Ring& cell : kinked_cells(polyline_path({a, b, a + 0.3 * (b - a)}), 4)) {
      ASSERT_NEAR(distance(cell[0], cell[3]), 4, 1e-9) << i;
      ASSERT_NEAR(distance(cell[1], cell[2]), 4, 1e-9) << i;
    }
  }
}

// However wild the line: a swath's parts never have more ground than its width times its length.
TEST(KinkedLine, CellsAreAsLargeAsTheirPartsOfTheTrackAreLong) {
  for (unsigned seed = 1; seed <= 200; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> jitter(-8, 8);
    std::vector<Point> line;
    for (int i = 0; i < 20; ++i) line.push_back({5.0 * i + jitter(random), jitter(random)});
    const Path path = polyline_path(line);
    const std::vector<Ring> cells = kinked_cells(path, 4);
    ASSERT_EQ(cells.size(), path.size());
    for (std::size_t i = 0; i < cells.size(); ++i) {
      EXPECT_NEAR(signed_area(cells[i]), 4 * length(path[i]), 1e-9);
      EXPECT_FALSE(find_invalidity({cells[i], {}}));
    }
  }
}

}  // namespace tramline::kinked_line_test
