#include "tramline/geometry/offset/parallel_pair.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tramline/geometry/path/smoothed_line.h"

namespace tramline::parallel_pair_test {

constexpr double kLeg = 200;

void expect_intervals(const Intervals& found, const Intervals& expected) {
  ASSERT_EQ(found.size(), expected.size());
  for (std::size_t i = 0; i < found.size(); ++i) {
    EXPECT_NEAR(found[i].from, expected[i].from, 1e-6) << i;
    EXPECT_NEAR(found[i].to, expected[i].to, 1e-6) << i;
  }
}

/// A contour along y = 0 that turns left by `turn` at the origin, 200 m before and after it.
Contour kinked(double turn, double radius) {
  return contour_of(
      smoothed({{-kLeg, 0}, {0, 0}, kLeg * Point{std::cos(turn), std::sin(turn)}}, radius).path);
}

TEST(ParallelPair, FollowsALineOnBothSides) {
  const Contour contour = contour_of(straight_path({0, 0}, {100, 0}));
  for (const double distance_m : {1.5, 60.0}) {
    const ParallelPair pair = parallel_pair(contour, distance_m, {6, 3}, Sides::kBoth);
    EXPECT_EQ(pair.distance_m, distance_m);
    expect_intervals(pair.stretches, {{0, 100}, {102, 202}});
    expect_intervals(pair.wide, {{0, 100}, {102, 202}});
    EXPECT_TRUE(pair.joins.empty());
    EXPECT_TRUE(pair.lost.empty());
  }
  expect_intervals(parallel_pair(contour, 1.5, {6, 3}, Sides::kRight).stretches, {{0, 100}});
  expect_intervals(parallel_pair(contour, 1.5, {6, 3}, Sides::kLeft).stretches, {{102, 202}});
}

// Fronts at t meet t·tan(τ/2) from the vertex. The swath reaches t + w/2, the disc t + ρ: what lies between
// is trimmed off both stretches and lost to the arc.
TEST(ParallelPair, JoinsTheLegsOfAKinkWhereTheDiscFits) {
  for (const double turn : {0.5, 1.2, 2.0}) {
    const Contour contour = kinked(turn, 8);
    const double t = 7.5, least = 6, half = 1.5, slope = std::tan(0.5 * turn);
    const ParallelPair pair = parallel_pair(contour, t, {least, 2 * half}, Sides::kLeft);
    const double disc = kLeg - (t + least) * slope, swath = kLeg - (t + half) * slope;
    const double start = contour.left_start(), end = contour.left_end();
    expect_intervals(pair.wide, {{start, start + disc}, {end - disc, end}});
    const Intervals trimmed{{start + disc, start + swath}, {end - swath, end - disc}};
    expect_intervals(pair.stretches, {{start, start + disc}, {end - disc, end}, trimmed[0], trimmed[1]});
    expect_intervals(pair.lost, trimmed);
    ASSERT_EQ(pair.joins.size(), 1U);
    EXPECT_EQ(pair.joins[0].before, 0U);
    EXPECT_EQ(pair.joins[0].after, 1U);
    EXPECT_NEAR(pair.joins[0].corner.turn_rad, turn, 1e-6);
    EXPECT_LT(distance(pair.joins[0].corner.point, {disc - kLeg, t + least}), 1e-6);
  }
}

TEST(ParallelPair, LeavesACornerSharperThanTheLimitOpen) {
  const double turn = 1.2, t = 7.5, half = 1.5;
  const Contour contour = kinked(turn, 8);
  const TrackLimits limits{6, 2 * half, Angle::radians(turn - 0.01)};
  const ParallelPair pair = parallel_pair(contour, t, limits, Sides::kLeft);
  EXPECT_TRUE(pair.joins.empty());
  EXPECT_TRUE(pair.lost.empty());
  const double swath = kLeg - (t + half) * std::tan(0.5 * turn);
  expect_intervals(pair.stretches, {{contour.left_start(), contour.left_start() + swath},
                                    {contour.left_end() - swath, contour.left_end()}});
}

// Where the radius is less than half the width, the disc is as wide as the swath, and nothing is trimmed off.
TEST(ParallelPair, TrimsNothingOffWhereTheMachineTurnsWithinItsWidth) {
  const double turn = 1.2, t = 9, half = 3;
  const Contour contour = kinked(turn, 8);
  const ParallelPair pair = parallel_pair(contour, t, {1, 2 * half}, Sides::kLeft);
  const double swath = kLeg - (t + half) * std::tan(0.5 * turn);
  expect_intervals(pair.stretches, {{contour.left_start(), contour.left_start() + swath},
                                    {contour.left_end() - swath, contour.left_end()}});
  EXPECT_EQ(pair.joins.size(), 1U);
  EXPECT_TRUE(pair.lost.empty());
}

// Between a line 50 m long and another one, a bend of radius 30 to the left.
TEST(ParallelPair, SkipsBendsThatAreTooTight) {
  const Path path{{{-50, 0}, {0, 0}, 0}, {{0, 0}, {30, 30}, 1 / 30.}, {{30, 30}, {30, 80}, 0}};
  const Contour contour = contour_of(path);
  const double start = contour.left_start(), end = contour.left_end();
  const TrackLimits limits{6, 3};
  expect_intervals(parallel_pair(contour, 23.9, limits, Sides::kLeft).stretches, {{start, end}});
  // Of 5.9 m: the swath still reaches round, but the machine cannot follow. The fronts of the legs at 30.1 m
  // meet 0.1 m before the bend.
  const ParallelPair tight = parallel_pair(contour, 24.1, limits, Sides::kLeft);
  expect_intervals(
      tight.stretches,
      {{start, start + 49.9}, {end - 49.9, end}, {start + 49.9, start + 50}, {end - 50, end - 49.9}});
  ASSERT_EQ(tight.joins.size(), 1U);
  EXPECT_LT(distance(tight.joins[0].corner.point, {-0.1, 30.1}), 1e-6);
  expect_intervals(parallel_pair(contour, 24.1, limits, Sides::kRight).stretches, {{0, contour.right_end()}});
}

}  // namespace tramline::parallel_pair_test
