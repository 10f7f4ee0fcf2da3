// Hulls by looking at all discs, and paths along them by hand.

#include "tramline/avoidance/detour/detour_hull.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "properties/seeds.h"

namespace tramline::detour_hull_test {

std::vector<KeepOut> random_discs(std::mt19937_64& random, int count) {
  std::uniform_real_distribution<double> along(-20, 20), off(-4, 4), radius(0.2, 5);
  std::vector<KeepOut> out;
  for (int i = 0; i < count; ++i) out.push_back({{along(random), off(random)}, radius(random)});
  return out;
}

/// How far a set of points reaches in a direction.
double reach_in(Point direction, const std::vector<Point>& points) {
  double farthest = -1e9;
  for (const Point p : points) farthest = std::max(farthest, dot(direction, p));
  return farthest;
}

// A post of 1 m, 3 m off the track, and one of 2 m, 1 m off: with arcs of 4 m both keep their peaks, so their
// centres sink by 3 m and by 2 m.
TEST(DetourHull, PressesSmallDiscsAgainstOnesThatCanBeDriven) {
  const Hull hull = hull_round({{{0, 3}, 1}, {{5, 1}, 2}}, 4, HullCorners::kDrivable);
  EXPECT_EQ(hull.radius, 4);
  ASSERT_EQ(hull.centres.size(), 2u);
  EXPECT_EQ(hull.centres[0], (Point{0, 0}));
  EXPECT_EQ(hull.centres[1], (Point{5, -1}));
  const Hull as_they_are = hull_round({{{0, 3}, 2}, {{5, 1}, 2}}, 4, HullCorners::kAsTheyAre);
  EXPECT_EQ(as_they_are.radius, 2);
  EXPECT_EQ(as_they_are.centres[0], (Point{0, 3}));
  EXPECT_EQ(hull_round({{{0, 3}, 6}, {{5, 1}, 2}}, 4, HullCorners::kDrivable).radius, 6);
}

TEST(DetourHull, LeavesOutWhatLiesBelow) {
  const Hull hull =
      hull_round({{{0, 0}, 2}, {{10, 0}, 2}, {{5, 0}, 2}, {{5, -3}, 2}, {{10, -1}, 2}, {{0, -1}, 2}}, 2,
                 HullCorners::kDrivable);
  ASSERT_EQ(hull.centres.size(), 2u) << "collinear ones too";
  EXPECT_EQ(hull.centres.front(), (Point{0, 0}));
  EXPECT_EQ(hull.centres.back(), (Point{10, 0}));
}

// In every direction with a share upwards the hull reaches as far as all discs that keep their peaks; its
// corners are convex and run from left to right; and every disc lies below the hull.
TEST(DetourHull, ReachesAsFarUpAsAllDiscs) {
  testing::for_each_seed(200, [](std::mt19937_64& random, int number) {
    const std::vector<KeepOut> discs = random_discs(random, 1 + number % 12);
    const double radius_m = 0.1 + 0.5 * (number % 17);
    const Hull hull = hull_round(discs, radius_m, HullCorners::kDrivable);
    double largest = radius_m;
    for (const KeepOut& disc : discs) largest = std::max(largest, disc.radius);
    ASSERT_EQ(hull.radius, largest);
    std::vector<Point> sunk;
    for (const KeepOut& disc : discs) sunk.push_back({disc.centre.x, disc.centre.y + disc.radius - largest});
    for (int i = 1; i < 180; ++i) {
      const Point up = turned({1, 0}, i * std::numbers::pi / 180);
      ASSERT_NEAR(reach_in(up, hull.centres), reach_in(up, sunk), 1e-9) << i << " degrees";
      for (const KeepOut& disc : discs)
        ASSERT_LE(dot(up, disc.centre) + disc.radius, reach_in(up, hull.centres) + largest + 1e-9);
    }
    for (std::size_t i = 1; i < hull.centres.size(); ++i) {
      ASSERT_LT(hull.centres[i - 1].x, hull.centres[i].x);
      if (i + 1 < hull.centres.size()) {
        ASSERT_LT(cross(hull.centres[i] - hull.centres[i - 1], hull.centres[i + 1] - hull.centres[i]), 0);
      }
    }
  });
}

TEST(DetourHull, MirroredTwiceIsItself) {
  const Hull hull{{{-3, 0}, {1, 2}, {6, 1}}, 2};
  const Hull mirror = mirrored(hull);
  EXPECT_EQ(mirror.centres, (std::vector<Point>{{-6, 1}, {-1, 2}, {3, 0}}));
  EXPECT_EQ(mirrored(mirror).centres, hull.centres);
  const Approach approach{2, {0.6, 0.8}, {9, -1}, {9, 0}};
  const Approach other = mirrored(approach, hull);
  EXPECT_EQ(other.vertex, 0u);
  EXPECT_EQ(other.normal, (Point{-0.6, 0.8}));
  EXPECT_EQ(other.arc_centre, (Point{-9, -1}));
  EXPECT_EQ(other.on_track, (Point{-9, 0}));
}

// The line's normal leans 75° to the right from straight up; no disc reaches over it, and one touches it.
TEST(DetourHull, TheSteepestLineTouchesItFromOutside) {
  testing::for_each_seed(100, [](std::mt19937_64& random, int number) {
    const Hull hull = hull_round(random_discs(random, 1 + number % 9), 3, HullCorners::kDrivable);
    const SteepLine line = steepest_line(hull);
    const Point normal = turned({0, 1}, -75 * std::numbers::pi / 180);
    ASSERT_NEAR(distance(line.touching.normal, normal), 0, 1e-12);
    ASSERT_NEAR(line.off_m, reach_in(normal, hull.centres) + hull.radius, 1e-9);
    ASSERT_NEAR(dot(normal, hull.centres[line.touching.vertex]) + hull.radius, line.off_m, 1e-9);
  });
}

// Arcs of 5 m out of the track y = 0 and back to it, round two discs of 4 m whose centres lie 10 m apart on y
// = 0: the track's arcs have their centres on y = 5, √(9² − 5²) m before and behind.
TEST(DetourHull, APathRunsAlongItsDiscsAndTheLineBetweenThem) {
  const Hull hull{{{0, 0}, {10, 0}}, 4};
  const double before = std::sqrt(81.0 - 25);
  const Point left{-before, 5}, right{10 + before, 5};
  const Approach in{0, (1.0 / 9) * left, left, {-before, 0}};
  const Approach out{1, (1.0 / 9) * (right - Point{10, 0}), right, {10 + before, 0}};
  const Path path = hull_path(hull, in, out, 5);
  ASSERT_EQ(path.size(), 5u);
  EXPECT_EQ(path.front().from, (Point{-before, 0}));
  EXPECT_EQ(path.back().to, (Point{10 + before, 0}));
  const double curvatures[] = {0.2, -0.25, 0, -0.25, 0.2};
  for (std::size_t i = 0; i < 5; ++i) EXPECT_NEAR(path[i].curvature, curvatures[i], 1e-12);
  EXPECT_NEAR(distance(path[2].from, {0, 4}), 0, 1e-12);
  EXPECT_NEAR(distance(path[2].to, {10, 4}), 0, 1e-12);
  // Both arcs of each end turn by the angle whose cosine is 5/9.
  EXPECT_NEAR(length(path), 10 + 2 * std::acos(5.0 / 9) * (5 + 4), 1e-9);
  for (std::size_t i = 0; i + 1 < path.size(); ++i)
    EXPECT_NEAR(distance(direction_at_end(path[i]), direction_at_start(path[i + 1])), 0, 1e-9);
}

// An arc of more than 127° round one disc comes in two, which together turn as far.
TEST(DetourHull, AWideArcComesInTwoParts) {
  const Hull hull{{{0, 6}}, 3};
  const double along = std::sqrt(8.0 * 8 - 1);  // arcs of 5 m: centres 8 m apart, one of them 1 m lower
  const Point left{-along, 5}, right{along, 5};
  const Approach in{0, (1.0 / 8) * (left - Point{0, 6}), left, {-along, 0}};
  const Approach out{0, (1.0 / 8) * (right - Point{0, 6}), right, {along, 0}};
  const Path path = hull_path(hull, in, out, 5);
  ASSERT_EQ(path.size(), 4u);
  EXPECT_NEAR(distance(path[1].to, {0, 9}), 0, 1e-9) << "at the peak";
  const double turn = std::numbers::pi / 2 + std::asin(1.0 / 8);
  EXPECT_NEAR(turning(path[1]) + turning(path[2]), -2 * turn, 1e-9);
}

}  // namespace tramline::detour_hull_test
