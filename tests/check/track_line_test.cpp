// Lines of curved tracks, by hand and against the parallels that plans are made of.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include "check/plans.h"
#include "tramline/check/lines/track_lines.h"
#include "tramline/check/measure/bands.h"
#include "tramline/geometry/offset/parallel.h"
#include "tramline/geometry/path/extended_line.h"
#include "tramline/geometry/path/smoothed_line.h"

namespace tramline {
namespace {

using namespace testing_plans;

check::TrackLines along(const Path& reference, double width_m, double radius_m) {
  Machine machine;
  machine.width_m = width_m;
  machine.radius_m = radius_m;
  return {reference, machine};
}

std::optional<Path> between(const check::TrackLines& lines, int track, Point from, Point heading, Point to) {
  return lines.known() ? check::TrackLine(lines.line(track)).between(from, heading, to) : std::nullopt;
}

/// North, a quarter turn to the right of 10 m, east: x = 0 up to the origin, y = 10 from x = 10.
Path elbow() { return {{{0, -60}, {0, 0}, 0}, {{0, 0}, {10, 10}, -0.1}, {{10, 10}, {70, 10}, 0}}; }

TEST(TrackLines, FollowBendsThatHaveRoomForTheMachine) {
  const check::TrackLines lines = along(elbow(), 3, 6);
  // 1.5 m to the right the bend has 8.5 m left, 1.5 m to the left 11.5 m.
  const auto inner = between(lines, 0, {1.5, -20}, {0, 1}, {20, 8.5});
  ASSERT_TRUE(inner);
  ASSERT_EQ(inner->size(), 3u);
  EXPECT_NEAR(radius((*inner)[1]), 8.5, 1e-9);
  EXPECT_NEAR(length(*inner), 20 + 8.5 * std::numbers::pi / 2 + 10, 1e-6);
  // Driven the other way it is the same line.
  EXPECT_EQ(between(lines, 0, {20, 8.5}, {-1, 0}, {1.5, -20}), reversed(*inner));
  const auto outer = between(lines, -1, {-1.5, -20}, {0, 1}, {20, 11.5});
  ASSERT_TRUE(outer);
  EXPECT_NEAR(length(*outer), 20 + 11.5 * std::numbers::pi / 2 + 10, 1e-6);
}

/// 4.5 m to the right 5.5 m are left, which is too tight: a disc of 6 m that touches both sides has its
/// centre 10.5 m from both lines.
TEST(TrackLines, RollRoundCorners) {
  const check::TrackLines lines = along(elbow(), 3, 6);
  const auto path = between(lines, 1, {4.5, -20}, {0, 1}, {20, 5.5});
  ASSERT_TRUE(path);
  ASSERT_EQ(path->size(), 3u);
  const PathSegment& arc = (*path)[1];
  EXPECT_NEAR(distance(arc.from, {4.5, -0.5}), 0, 1e-5);
  EXPECT_NEAR(distance(arc.to, {10.5, 5.5}), 0, 1e-5);
  EXPECT_NEAR(radius(arc), 6, 1e-9);
  const double half = std::numbers::sqrt2 / 2;
  const Point on_arc{10.5 - 6 * half, -0.5 + 6 * half};
  const auto part = between(lines, 1, on_arc, {1, 1}, {20, 5.5});
  ASSERT_TRUE(part);
  EXPECT_NEAR(length(*part), 6 * std::numbers::pi / 4 + 9.5, 1e-5);
  EXPECT_TRUE(check::holds(*path, on_arc));
  EXPECT_FALSE(check::holds(*path, on_arc + Point{0.002, -0.002}));

  // 8 cm round the corner the arc is half a millimetre off the side that it leaves: on the line both ways.
  const double turned = 0.08 / 6;
  const Point early{10.5 - 6 * std::cos(turned), -0.5 + 6 * std::sin(turned)};
  const auto rest = between(lines, 1, early, {0, 1}, {20, 5.5}),
             before = between(lines, 1, {4.5, -20}, {0, 1}, early);
  ASSERT_TRUE(rest);
  EXPECT_NEAR(length(*rest), 6 * (std::numbers::pi / 2 - turned) + 9.5, 1e-5);
  ASSERT_TRUE(before);
  EXPECT_NEAR(length(*before), 19.5 + 0.08, 1e-5);

  const check::ParallelLine line = lines.line(1);
  EXPECT_TRUE(line.rolls_round_corner(arc, on_arc));
  EXPECT_FALSE(line.rolls_round_corner({arc.from, arc.to, -1 / 6.01}, on_arc));
  EXPECT_FALSE(
      line.rolls_round_corner({arc.from + Point{0.003, -0.003}, arc.to + Point{0.003, -0.003}, arc.curvature},
                              on_arc + Point{0.003, -0.003}));
  // The same disc behind where it touches.
  EXPECT_FALSE(
      line.rolls_round_corner({{10.5, 5.5}, {16.5, -0.5}, -1 / 6.0}, {10.5 + 6 * half, -0.5 + 6 * half}));
}

/// Places off the line, of another track, or beyond the ends of the reference.
TEST(TrackLines, DoNotLeadWhereTheyDoNotRun) {
  const check::TrackLines lines = along(elbow(), 3, 6);
  EXPECT_FALSE(between(lines, 1, {4.502, -20}, {0, 1}, {20, 5.5}));
  EXPECT_TRUE(between(lines, 1, {4.5005, -20}, {0, 1}, {20, 5.5}));
  EXPECT_FALSE(between(lines, 2, {4.5, -20}, {0, 1}, {20, 5.5}));
  EXPECT_FALSE(between(lines, -2, {4.5, -20}, {0, 1}, {20, 5.5}));
  EXPECT_FALSE(between(lines, 1, {4.5, -61}, {0, 1}, {20, 5.5}));
  EXPECT_FALSE(between(lines, 1, {4.5, -20}, {0, -1}, {20, 5.5}));  // looks the other way
  // One nearer to the reference, too: on its arc the place might be.
  EXPECT_EQ(lines.tracks_near({4.5, -20}), (std::vector<int>{1, 0}));
  EXPECT_EQ(lines.tracks_near({-4.5, -20}), (std::vector<int>{-2, -1}));
  const check::TrackLines tight = along(elbow(), 3, 10.2);
  EXPECT_FALSE(between(tight, 0, {1.5, -20}, {0, 1}, {20, 8.5}));
}

/// A turn of 135° is not driven round: both sides are lines of their own.
TEST(TrackLines, EndInSharpCorners) {
  const double half = std::numbers::sqrt2 / 2;
  const Point turned{10 + 10 * half, 10 * half};  // the arc's end, heading south-east; the centre is (10, 0)
  const Path reference{
      {{0, -60}, {0, 0}, 0}, {{0, 0}, turned, -0.1}, {turned, turned + 60 * Point{half, -half}, 0}};
  const check::TrackLines lines = along(reference, 3, 6);
  EXPECT_NEAR(turning(reference[1]), -3 * std::numbers::pi / 4, 1e-12);
  EXPECT_TRUE(between(lines, 0, {1.5, -20}, {0, 1}, {1.5, -1}));
  const Point right{-half, -half};
  const Point beyond = turned + 40 * Point{half, -half} + 7.5 * right;
  EXPECT_FALSE(between(lines, 2, {7.5, -40}, {0, 1}, beyond));
  EXPECT_TRUE(between(lines, 2, beyond, {half, -half}, beyond + 5 * Point{half, -half}));
}

/// Round a circle of 40 m, anticlockwise: the tracks on its left are closed.
TEST(TrackLines, ComeBackToWhereTheyBegan) {
  const Path circle{{{40, 0}, {-40, 0}, 1 / 40.0}, {{-40, 0}, {40, 0}, 1 / 40.0}};
  const check::TrackLines lines = along(circle, 4, 6);
  EXPECT_TRUE(lines.line(-2).may_close());
  const auto over_the_seam = between(lines, -2, {0, -34}, {1, 0}, {0, 34});
  ASSERT_TRUE(over_the_seam);
  EXPECT_NEAR(length(*over_the_seam), 34 * std::numbers::pi, 1e-3);
  EXPECT_TRUE(check::holds(*over_the_seam, {34, 0}));
  EXPECT_FALSE(check::holds(*over_the_seam, {-34, 0}));
  EXPECT_FALSE(along(elbow(), 3, 6).line(-2).may_close());
}

/// A line that wanders east, without kinks.
Path wandering(std::mt19937& random, double radius_m) {
  std::uniform_real_distribution<double> length_m(15, 60), heading(-1.1, 1.1);
  std::vector<Point> points{{0, 0}};
  for (int i = 0; i < 8; ++i) {
    const double angle = heading(random), step_m = length_m(random);
    points.push_back(points.back() + step_m * Point{std::cos(angle), std::sin(angle)});
  }
  return smoothed(points, radius_m, 0.5).path;
}

/// The parallels that plans are made of lead where these lines do, and are as long.
TEST(TrackLines, AgreeWithParallels) {
  int compared = 0, with_corners = 0;
  for (unsigned seed = 0; seed < 40; ++seed) {
    std::mt19937 random(seed);
    TrackLimits limits;
    limits.width_m = 3 + seed % 4;
    limits.radius_m = 2 + seed % 7;
    Box box;
    box.extend(Point{-20, -150});
    box.extend(Point{450, 150});
    const Path reference = extended(wandering(random, limits.least_radius_m()), box).path;
    const check::TrackLines lines = along(reference, limits.width_m, limits.radius_m);
    ASSERT_TRUE(lines.known()) << seed;
    for (const FamilyTrack& each : parallel_family(reference, -20, 19, limits)) {
      const Path path = check::shortened(each.track.path, 0.01);
      if (path.empty()) continue;
      const auto line =
          between(lines, each.index, path.front().from, direction_at_start(path.front()), path.back().to);
      EXPECT_TRUE(line) << "seed " << seed << ", track " << each.index;
      if (!line) continue;
      EXPECT_NEAR(length(*line), length(path), 0.01) << "seed " << seed << ", track " << each.index;
      for (const PathSegment& segment : path) {
        const Point middle = check::point_on(segment, 0.5 * length(segment));
        EXPECT_TRUE(check::holds(*line, middle)) << "seed " << seed << ", track " << each.index;
        with_corners += lines.line(each.index).rolls_round_corner(segment, middle) ? 1 : 0;
      }
      ++compared;
    }
  }
  EXPECT_GT(compared, 1200);
  EXPECT_GT(with_corners, 100);
}

}  // namespace
}  // namespace tramline
