#include "tramline/geometry/offset/parallel.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "geometry/drivable.h"
#include "tramline/geometry/path/extended_line.h"
#include "tramline/geometry/path/smoothed_line.h"
#include "tramline/geometry/polygon/boolean.h"

namespace tramline::parallel_test {

constexpr double kPi = std::numbers::pi;

/// A line along y = 0 that turns left by `turn` at the origin, 200 m before and after it.
Path kinked(double turn, double radius) {
  return smoothed({{-200, 0}, {0, 0}, {200 * std::cos(turn), 200 * std::sin(turn)}}, radius).path;
}

/// Two legs along x = ±half, open at the top, joined by half a circle at the bottom.
Path u_shape(double half, double depth) {
  return {{{-half, depth}, {-half, 0}, 0},
          {{-half, 0}, {0, -half}, 1 / half},
          {{0, -half}, {half, 0}, 1 / half},
          {{half, 0}, {half, depth}, 0}};
}

Region bands(const std::vector<ParallelTrack>& tracks, double width) {
  Region out;
  for (const ParallelTrack& track : tracks) out.push_back({band(track.path, width, 1e-4), {}});
  return out;
}

double area_of_holes(const Region& region) {
  double sum = 0;
  for (const Polygon& polygon : region)
    for (const Ring& hole : polygon.holes) sum += std::abs(signed_area(hole));
  return sum;
}

TEST(Parallel, OfAStraightLineIsAStraightLine) {
  const Path north = straight_path({10, 0}, {10, 100});
  for (const auto& [offset, x] : {std::pair{1.5, 11.5}, {-1.5, 8.5}, {301.5, 311.5}}) {
    const std::vector<ParallelTrack> tracks = parallel(north, offset, {6, 3});
    ASSERT_EQ(tracks.size(), 1u);
    EXPECT_EQ(tracks.front().path, straight_path({x, 0}, {x, 100})) << "right is positive";
    EXPECT_FALSE(tracks.front().closed);
  }
}

// A quarter of a circle to the left, radius 100: 100 + t on its right, 100 − t on its left.
TEST(Parallel, OfAnArcIsAnArc) {
  const Path arc{{{100, 0}, {0, 100}, 0.01}};
  for (const double t : {1.5, 40.5, 90.0}) {
    const std::vector<ParallelTrack> outside = parallel(arc, t, {6, 3}), inside = parallel(arc, -t, {6, 3});
    ASSERT_EQ(outside.size(), 1u);
    ASSERT_EQ(inside.size(), 1u);
    EXPECT_NEAR(length(outside.front().path), (100 + t) * kPi / 2, 1e-9);
    EXPECT_NEAR(length(inside.front().path), (100 - t) * kPi / 2, 1e-9);
    EXPECT_NEAR(inside.front().path.front().from.x, 100 - t, 1e-9) << "in the sense of the reference";
  }
  EXPECT_TRUE(parallel(arc, -95, {6, 3}).empty()) << "tighter than 6 m";
}

// Inside a kink of turn τ the fronts at t + ρ meet (t + ρ)·tan(τ/2) before the vertex; the arc about that
// point is ρ·τ long.
TEST(Parallel, RoundsACornerAboutWhereTheNextFrontsMeet) {
  for (const double turn : {0.2, 1.0, kPi / 2, 2.0}) {
    const double t = 10, radius = 6;
    const std::vector<ParallelTrack> tracks = parallel(kinked(turn, radius), -t, {radius, 2});
    ASSERT_EQ(tracks.size(), 1u);
    expect_drivable(tracks.front().path, radius);
    ASSERT_EQ(tracks.front().path.size(), 3u);
    EXPECT_NEAR(length(tracks.front().path), 2 * (200 - (t + radius) * std::tan(turn / 2)) + radius * turn,
                1e-6);
  }
}

// The far side of one swath turns about its centre with radius ρ − w/2, the near side of the next one
// with ρ + w/2. Rounding a corner of turn τ with radius q cuts q²(tan(τ/2) − τ/2) off, so the two leave
// ((ρ + w/2)² − (ρ − w/2)²)(tan(τ/2) − τ/2) = 2ρw(tan(τ/2) − τ/2) between them.
TEST(Parallel, LeavesTheKnownGapsInACorner) {
  for (const double turn : {0.5, kPi / 2, 2.0}) {
    const double w = 4, radius = 6, t = 14;
    const Path reference = kinked(turn, radius);
    Region swaths = bands(parallel(reference, -t, {radius, w}), w);
    for (Polygon& next : bands(parallel(reference, -(t + w), {radius, w}), w)) swaths.push_back(next);
    ASSERT_EQ(swaths.size(), 2u);
    EXPECT_NEAR(area_of_holes(unite(swaths)), 2 * radius * w * (std::tan(turn / 2) - turn / 2), 5e-3);
    EXPECT_NEAR(area(swaths), area(unite(swaths)), 1e-2);
  }
}

TEST(Parallel, EndsBothBranchesInASharpCorner) {
  const std::vector<ParallelTrack> tracks = parallel(kinked(2.5, 6), -31, {6, 2, Angle::degrees(120)});
  ASSERT_EQ(tracks.size(), 2u);
  // Swaths that are 32 m deep fit up to 32·tan(τ/2) before the vertex.
  for (const ParallelTrack& track : tracks) EXPECT_NEAR(length(track.path), 200 - 32 * std::tan(1.25), 1e-6);
  EXPECT_EQ(parallel(kinked(2.5, 6), -31, {6, 2, Angle::degrees(150)}).size(), 1u);
}

// Fronts meet in the middle of a U: round the bottom as long as it is wide enough to turn, then up and
// down each leg, and nothing is worked twice.
TEST(Parallel, FillsAUFromBothLegs) {
  const Path reference = u_shape(30, 200);
  constexpr double kWidth = 4;
  Region all;
  for (int k = 0; k < 12; ++k) {
    const double t = (k + 0.5) * kWidth;
    const std::vector<ParallelTrack> tracks = parallel(reference, -t, {6, kWidth});
    if (t <= 24) {
      ASSERT_EQ(tracks.size(), 1u) << t;
      EXPECT_NEAR(length(tracks.front().path), 400 + (30 - t) * kPi, 1e-9);
    } else if (t <= 28) {
      ASSERT_EQ(tracks.size(), 2u) << t;
      EXPECT_NEAR(length(tracks.front().path) + length(tracks.back().path), 400, 1e-9);
    } else {
      EXPECT_TRUE(tracks.empty()) << t;
    }
    for (const ParallelTrack& track : tracks) {
      expect_drivable(track.path, 6);
      all.push_back({band(track.path, kWidth, 1e-4), {}});
    }
  }
  EXPECT_NEAR(area(unite(all)), area(all), 1e-5 * area(all));
}

// Two rooms with a narrow passage between them: fronts fill it first, and then each room has closed tracks
// of its own.
TEST(Parallel, ReachesEveryLobe) {
  const Path reference = smoothed({{0, -20},
                                   {-60, -20},
                                   {-60, 60},
                                   {-10, 80},
                                   {-60, 100},
                                   {-60, 180},
                                   {60, 180},
                                   {60, 100},
                                   {10, 80},
                                   {60, 60},
                                   {60, -20},
                                   {1, -20}},
                                  6)
                             .path;
  constexpr double kWidth = 4;
  Region all;
  for (int k = 0; k < 10; ++k) {
    bool upper = false, lower = false;
    for (const ParallelTrack& track : parallel(reference, (k + 0.5) * kWidth, {6, kWidth})) {
      expect_drivable(track.path, 6, track.closed);
      const Box reach = reach_of(track.path, 0);
      upper = upper || (reach.min_y > 80 && track.closed);  // the lower room has the reference's two ends
      lower = lower || reach.max_y < 80;
      if (!track.closed) all.push_back({band(track.path, kWidth, 1e-4), {}});
    }
    EXPECT_EQ(upper && lower, k >= 5) << k;  // rounded, the passage is 40 m wide
  }
  EXPECT_NEAR(area(unite(all)), area(all), 1e-5 * area(all));
}

/// 50 m straight on, 10 m along an arc to the right, 50 m straight on. Half way along the arc stand 0.1 µm
/// that head 1 nrad further to the left than the arc does, as where stretches meet that are joined in
/// floating point.
Path arc_with_a_joint() {
  constexpr double kRadius_m = 30, kHalf_rad = 5 / kRadius_m, kJoint_m = 1e-7, kTurned_rad = 1e-9;
  const auto ahead = [](Point from, double heading_rad, double length_m) {
    return from + length_m * Point{std::cos(heading_rad), std::sin(heading_rad)};
  };
  const auto along_arc = [&](Point from, double heading_rad) {
    return ahead(from, heading_rad - 0.5 * kHalf_rad, 2 * kRadius_m * std::sin(0.5 * kHalf_rad));
  };
  const Point a{50, 0}, b = along_arc(a, 0), c = ahead(b, -kHalf_rad + kTurned_rad, kJoint_m),
                        d = along_arc(c, -kHalf_rad), e = ahead(d, -2 * kHalf_rad, 50);
  return {{{0, 0}, a, 0}, {a, b, -1 / kRadius_m}, {b, c, 0}, {c, d, -1 / kRadius_m}, {d, e, 0}};
}

// 300 m to the left of the joint, 1 nrad is 0.3 µm: three times the joint, and backwards. The heading of such
// a step back is that of the track turned round, and so would its band be.
TEST(Parallel, NeverStepsBackWhereHeadingsMeetButForRounding) {
  const std::vector<ParallelTrack> tracks = parallel(arc_with_a_joint(), -300.5, {6, 3});
  ASSERT_EQ(tracks.size(), 1u);
  const Path& path = tracks.front().path;
  ASSERT_GE(path.size(), 4u);
  for (std::size_t i = 1; i < path.size(); ++i)
    EXPECT_GT(dot(path[i].to - path[i].from, path[i - 1].to - path[i - 1].from), 0) << i;
  EXPECT_NEAR(length(path), 100 + 10 * (30 + 300.5) / 30, 1e-4);
}

TEST(Parallel, FamilyIsWhatTheTracksAreOneByOne) {
  const Path reference = extended(kinked(1.2, 6), Box{-100, -100, 150, 150}).path;
  const TrackLimits limits{6, 3};
  std::vector<FamilyTrack> one_by_one;
  for (int k = -40; k <= 40; ++k)
    for (ParallelTrack& track : parallel(reference, (k + 0.5) * 3, limits))
      one_by_one.push_back({k, std::move(track)});
  const std::vector<FamilyTrack> family = parallel_family(reference, -40, 40, limits);
  ASSERT_EQ(family.size(), one_by_one.size());
  for (std::size_t i = 0; i < family.size(); ++i) {
    EXPECT_EQ(family[i].index, one_by_one[i].index);
    EXPECT_EQ(family[i].track, one_by_one[i].track);
  }
}

}  // namespace tramline::parallel_test
