// How far apart lines and arcs are, against many points on them.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include "tramline/check/measure/bands.h"
#include "tramline/check/measure/path_distance.h"
#include "tramline/geometry/path/kinked_line.h"

namespace tramline {
namespace {

TEST(PathDistance, OfRandomSegments) {
  std::mt19937_64 random(7);
  const auto between = [&random](double from, double to) {
    return std::uniform_real_distribution<double>(from, to)(random);
  };
  const auto segment = [&] {
    const Point from{between(-5, 5), between(-5, 5)}, to{between(-5, 5), between(-5, 5)};
    const double most = 2 / distance(from, to);
    return PathSegment{from, to, between(0, 1) < 0.2 ? 0 : between(-most, most)};
  };
  int met = 0, apart = 0;
  for (int i = 0; i < 400; ++i) {
    const PathSegment a = segment(), b = segment();
    double least = 1e9;
    constexpr int kLooks = 300;
    for (int k = 0; k <= kLooks; ++k) {
      const Point p = check::point_on(Path{a}, length(a) * k / kLooks);
      least = std::min(least, distance_to_edge(b, p, p));
    }
    const double found = check::distance_between(a, b);
    EXPECT_DOUBLE_EQ(found, check::distance_between(b, a));
    EXPECT_LE(found, least + 1e-9);
    EXPECT_GE(found, least - length(a) / kLooks);
    (found == 0 ? met : apart) += 1;
  }
  EXPECT_GT(met, 50);
  EXPECT_GT(apart, 50);
}

TEST(PathDistance, OfArcsAboutOneCentre) {
  const PathSegment a{{10, 0}, {0, 10}, 0.1}, b{{0, 13}, {13, 0}, -1 / 13.0}, c{{0, -13}, {13, 0}, 1 / 13.0};
  EXPECT_NEAR(check::distance_between(a, b), 3, 1e-12);
  EXPECT_NEAR(check::distance_between(a, c), 3, 1e-12);
}

/// Bands of neighbours share the vertices between them, and are as large as width times length but for
/// chords.
TEST(Bands, SideBySideShareTheirEdges) {
  for (const double sense : {1.0, -1.0}) {
    const auto arc = [sense](double radius_m) {
      const Path path{{{radius_m, 1e-9}, {0, radius_m}, 1 / radius_m}};
      return sense > 0 ? path : reversed(path);
    };
    const Region inner = check::bands_along(arc(20), 4, 1e-4), outer = check::bands_along(arc(24), 4, 1e-4);
    ASSERT_EQ(inner.size(), 1u);
    EXPECT_GT(signed_area(inner[0].outer), 0);
    EXPECT_NEAR(area(inner), 4 * 10 * std::numbers::pi, 4 * 10 * std::numbers::pi * 1e-4);
    int shared = 0, on_edge = 0;
    for (const Point p : inner[0].outer) {
      if (std::abs(length(p) - 22) > 1e-6) continue;
      ++on_edge;
      shared += static_cast<int>(std::any_of(outer[0].outer.begin(), outer[0].outer.end(),
                                             [p](Point q) { return distance(p, q) < 1e-7; }));
    }
    EXPECT_GT(on_edge, 100);
    EXPECT_EQ(shared, on_edge);
  }
}

/// East, then north: what the first gains outside the kink it loses inside.
TEST(Bands, MeetOnTheBisectorsOfKinks) {
  const Region bands = check::bands_along({{{0, 0}, {10, 0}, 0}, {{10, 0}, {10, 10}, 0}}, 2);
  ASSERT_EQ(bands.size(), 2u);
  EXPECT_EQ(bands[0].outer, (Ring{{0, -1}, {11, -1}, {9, 1}, {0, 1}}));
  EXPECT_EQ(bands[1].outer, (Ring{{11, -1}, {11, 10}, {9, 10}, {9, 1}}));
  // Back at an angle of more than 120°, and a step between two kinks too short for both bisectors.
  const Region sharp = check::bands_along({{{0, 0}, {10, 0}, 0}, {{10, 0}, {0, 4}, 0}}, 2);
  EXPECT_EQ(sharp[0].outer, (Ring{{0, -1}, {10, -1}, {10, 1}, {0, 1}}));
  const Region step =
      check::bands_along({{{0, 0}, {10, 0}, 0}, {{10, 0}, {10, 1}, 0}, {{10, 1}, {0, 1}, 0}}, 2);
  EXPECT_EQ(step[0].outer, (Ring{{0, -1}, {10, -1}, {10, 1}, {0, 1}}));
  EXPECT_EQ(step[1].outer, (Ring{{11, 0}, {11, 1}, {9, 1}, {9, 0}}));
}

/// As plans are made of.
TEST(Bands, AtKinksAreThoseOfPlans) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> turn(-2.6, 2.6), step_m(0.5, 12);
  int flat = 0;
  for (int i = 0; i < 400; ++i) {
    std::vector<Point> points{{0, 0}};
    double angle = 0;
    for (int k = 0; k < 7; ++k) {
      points.push_back(points.back() + step_m(random) * Point{std::cos(angle), std::sin(angle)});
      angle += turn(random) * (k % 2 == 0 ? 0.3 : 1);
    }
    const Path path = polyline_path(points);
    const Region bands = check::bands_along(path, 3);
    const std::vector<Ring> cells = kinked_cells(path, 3);
    ASSERT_EQ(bands.size(), cells.size());
    for (std::size_t k = 0; k < cells.size(); ++k) {
      ASSERT_EQ(bands[k].outer.size(), 4u);
      for (std::size_t corner = 0; corner < 4; ++corner)
        EXPECT_LT(distance(bands[k].outer[corner], cells[k][corner]), 1e-9) << i << ' ' << k;
      EXPECT_NEAR(area(bands[k]), 3 * length(path[k]), 1e-9);
      const Point end = bands[k].outer[1] - bands[k].outer[2];
      flat += std::abs(dot(end, direction_at_start(path[k]))) < 1e-9 ? 1 : 0;
    }
  }
  EXPECT_GT(flat, 400 + 100);
}

TEST(Bands, ShortenedPaths) {
  const Path path{{{0, 0}, {10, 0}, 0}, {{10, 0}, {20, 10}, 0.1}};
  const Path inner = check::shortened(path, 2);
  EXPECT_NEAR(length(inner), length(path) - 4, 1e-9);
  EXPECT_NEAR(distance(inner.front().from, {2, 0}), 0, 1e-9);
  EXPECT_NEAR(distance(inner.back().to, Point{10 + 10 * std::cos(0.2), 10 - 10 * std::sin(0.2)}), 0, 1e-9);
  EXPECT_TRUE(check::shortened(path, 13).empty());
}

// The first segment is 10 m but for rounding: nothing of it is left, or else the rest would have no
// direction.
TEST(Bands, NoSegmentWithoutADirectionIsLeft) {
  const Path path{{{0, 0}, {10 + 1e-13, 0}, 0}, {{10 + 1e-13, 0}, {20, 10}, 0.1}};
  const Path rest = check::begun_later(path, 10);
  ASSERT_EQ(rest.size(), 1U);
  EXPECT_NE(rest.front().curvature, 0);
}

}  // namespace
}  // namespace tramline
