// What headlands leave of tracks, by hand and against points along them.

#include "tramline/planner/headland_choice/shortened_tracks.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include "properties/seeds.h"

namespace tramline {
namespace {

TrackPiece straight(Point from, Point to) {
  TrackPiece out;
  out.start = from;
  out.end = to;
  return out;
}

/// A field of 100 m × 60 m, 3 m passes; edges: south, east, north, west.
Plan layout(std::vector<TrackPiece> pieces) {
  Plan out;
  out.field.outer = {{0, 0}, {100, 0}, {100, 60}, {0, 60}};
  out.machine.width_m = 3;
  out.machine.min_length_m = 6;
  out.pieces = std::move(pieces);
  return out;
}

void expect_ends(const TrackPiece& piece, Point start, Point end) {
  EXPECT_NEAR(distance(piece.start, start), 0, 1e-9) << piece.start.x << ' ' << piece.start.y;
  EXPECT_NEAR(distance(piece.end, end), 0, 1e-9) << piece.end.x << ' ' << piece.end.y;
}

TEST(ShortenedTracks, EndBeforeThePasses) {
  const Plan plan = layout({straight({0, 30}, {100, 30}), straight({100, 33}, {0, 33})});
  const std::vector<TrackPiece> left = shortened_tracks(plan, {{0, 2, 0, 1}, {}});
  ASSERT_EQ(left.size(), 2U);
  expect_ends(left[0], {3, 30}, {94, 30});
  expect_ends(left[1], {94, 33}, {3, 33});
}

TEST(ShortenedTracks, OfNoPassesStayAsTheyAre) {
  const Plan plan = layout({straight({0, 30}, {100, 30})});
  const std::vector<TrackPiece> left = shortened_tracks(plan, {{0, 0, 0, 0}, {}});
  ASSERT_EQ(left.size(), 1U);
  EXPECT_EQ(left[0].start, plan.pieces[0].start);
  EXPECT_EQ(left[0].end, plan.pieces[0].end);
}

// 5 m north of an obstacle of 10 m whose two passes are 6 m deep: 3 m of its width, and √(6² − 5²) m on
// either side where the passes go round its corners.
TEST(ShortenedTracks, ArePartedByPassesRoundAnObstacle) {
  Plan plan = layout({straight({0, 30}, {100, 30})});
  Obstacle obstacle;
  obstacle.shape.outer = {{40, 15}, {50, 15}, {50, 25}, {40, 25}};
  plan.field.obstacles.push_back(obstacle);
  const std::vector<TrackPiece> left = shortened_tracks(plan, {{0, 0, 0, 0}, {2}});
  ASSERT_EQ(left.size(), 2U);
  expect_ends(left[0], {0, 30}, {40 - std::sqrt(11), 30});
  expect_ends(left[1], {50 + std::sqrt(11), 30}, {100, 30});
}

TEST(ShortenedTracks, LeaveOutWhatIsTooShort) {
  const Plan plan = layout({straight({0, 30}, {14.9, 30}), straight({0, 33}, {15, 33})});
  const std::vector<TrackPiece> left = shortened_tracks(plan, {{0, 0, 0, 3}, {}});
  ASSERT_EQ(left.size(), 1U);
  expect_ends(left[0], {9, 33}, {15, 33});
}

// What followed across a passable obstacle follows a turn once the track before is gone.
TEST(ShortenedTracks, CrossNothingWhereTheTrackBeforeIsGone) {
  Plan plan = layout({straight({0, 30}, {8, 30}), straight({10, 30}, {100, 30})});
  plan.pieces[1].after_crossing = true;
  EXPECT_TRUE(shortened_tracks(plan, {{0, 1, 0, 0}, {}}).back().after_crossing);
  EXPECT_FALSE(shortened_tracks(plan, {{0, 0, 0, 1}, {}}).back().after_crossing);
}

TEST(ShortenedTracks, KeepDetoursWhole) {
  Plan plan = layout({straight({0, 30}, {100, 30})});
  Detour detour;
  detour.path = {{{4, 30}, {50, 40}, 0}, {{50, 40}, {60, 30}, 0}};
  plan.pieces[0].detours = {detour};
  const std::vector<TrackPiece> left = shortened_tracks(plan, {{0, 4, 0, 2}, {}});
  ASSERT_EQ(left.size(), 1U);
  expect_ends(left[0], {4, 30}, {88, 30});
}

// A quarter of a circle of 50 m about the field's corner in the south-west, from its southern edge on: 6 m
// north of it after 50·asin(6/50) m.
TEST(ShortenedTracks, AlongCurvesEndWithinAQuarterOfAWidth) {
  Plan plan = layout({straight({50, 0}, {0, 50})});
  plan.pieces[0].curve = {{{50, 0}, {0, 50}, 1.0 / 50}};
  const std::vector<TrackPiece> left = shortened_tracks(plan, {{2, 0, 0, 0}, {}});
  ASSERT_EQ(left.size(), 1U);
  const double whole_m = 25 * std::numbers::pi, off_m = 50 * std::asin(6.0 / 50);
  EXPECT_LE(length(left[0].curve), whole_m - off_m + 1e-9);
  EXPECT_GT(length(left[0].curve), whole_m - off_m - 0.75);
}

double nearest_m(const Ring& ring, const std::vector<int>& passes, Point p, double width_m) {
  double out = 1e9;
  for (std::size_t i = 0; i < ring.size(); ++i)
    if (passes[i] > 0)
      out = std::min(out, distance_to_segment(p, ring[i], ring[(i + 1) % ring.size()]) - passes[i] * width_m);
  return out;
}

// Every point of a track is either on what is left of it, or within the passes of some edge, or on a rest too
// short to work.
TEST(ShortenedTracks, LoseWhatIsWithinThePassesAndNothingElse) {
  testing::for_each_seed(300, [](std::mt19937_64& random, int) {
    std::uniform_real_distribution<double> x(0, 100), y(0, 60);
    Plan plan = layout({straight({x(random), y(random)}, {x(random), y(random)})});
    plan.machine.min_length_m = 0;
    if (distance(plan.pieces[0].start, plan.pieces[0].end) < 1) return;
    plan.field.outer.insert(plan.field.outer.begin() + 3, Point{40 + 0.2 * x(random), 35});
    std::vector<int> passes;
    for (int i = 0; i < 5; ++i) passes.push_back(std::uniform_int_distribution<int>(0, 4)(random));
    const std::vector<TrackPiece> left = shortened_tracks(plan, {passes, {}});
    const Point along = plan.pieces[0].end - plan.pieces[0].start;
    for (double share = 0.0005; share < 1; share += 0.001) {
      const Point p = plan.pieces[0].start + share * along;
      const double off_m = nearest_m(plan.field.outer, passes, p, 3);
      if (std::abs(off_m) < 1e-6) continue;
      const bool is_left = std::any_of(left.begin(), left.end(), [&](const TrackPiece& piece) {
        return distance_to_segment(p, piece.start, piece.end) < 1e-9;
      });
      EXPECT_EQ(is_left, off_m > 0) << share << ' ' << off_m;
    }
  });
}

}  // namespace
}  // namespace tramline
