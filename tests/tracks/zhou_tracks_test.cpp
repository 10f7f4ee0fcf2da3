#include "tramline/tracks/zhou_tracks.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include "tramline/geometry/path/kinked_line.h"
#include "tramline/model/objective.h"
#include "tramline/tracks/laid_pieces.h"
#include "tramline/tracks/straight_tracks.h"

namespace tramline::zhou_tracks_test {

constexpr double kPi = std::numbers::pi;

/// 20 m on the right of a line that turns left by `turn` after 100 m; ends across it.
Polygon right_of_bend(double turn, double leg_m, double depth_m) {
  const Point along{std::cos(turn), std::sin(turn)}, right{std::sin(turn), -std::cos(turn)};
  const Point corner = (depth_m / (1 + std::cos(turn))) * (Point{0, -1} + right);
  return {{{-leg_m, 0}, {-leg_m, -depth_m}, corner, leg_m * along + depth_m * right, leg_m * along, {0, 0}},
          {}};
}

std::vector<Point> bend(double turn, double leg_m) {
  return {{-leg_m, 0}, {0, 0}, {leg_m * std::cos(turn), leg_m * std::sin(turn)}};
}

// Outside a kink of τ every track is longer than the last by 2 w tan(τ/2).
TEST(RecursiveTracks, GrowOutsideAKink) {
  for (const double degrees : {20.0, 60.0, 100.0}) {
    const double turn = degrees * kPi / 180, width = 4;
    const LaidTracks tracks = zhou_tracks(bend(turn, 100), width, {right_of_bend(turn, 100, 20)}, 0);
    ASSERT_EQ(tracks.pieces.size(), 5u) << degrees;
    for (int k = 0; k < 5; ++k) {
      const LaidPiece& piece = tracks.pieces[static_cast<std::size_t>(k)];
      EXPECT_EQ(piece.track, k);
      EXPECT_NEAR(piece.length_m, 200 + 2 * (k + 0.5) * width * std::tan(0.5 * turn), 1e-3) << degrees;
      ASSERT_EQ(piece.path.size(), 2u);
      // The kink is on the bisector, (k + ½)·w/cos(τ/2) out.
      EXPECT_NEAR(length(piece.path[0].to), (k + 0.5) * width / std::cos(0.5 * turn), 1e-9);
    }
  }
}

// The same land with the line on its far side: inside the kink tracks get shorter by as much.
TEST(RecursiveTracks, ShrinkInsideAKink) {
  const double turn = 60 * kPi / 180, width = 4, more = 20 * std::tan(0.5 * turn);
  const Polygon body = right_of_bend(turn, 100, 20);
  const std::vector<Point> line{body.outer[1], body.outer[2], body.outer[3]};
  const LaidTracks tracks = zhou_tracks(line, width, {body}, 0);
  ASSERT_EQ(tracks.pieces.size(), 5u);
  for (int k = 0; k < 5; ++k) {
    const LaidPiece& piece = tracks.pieces[static_cast<std::size_t>(4 - k)];
    EXPECT_EQ(piece.track, -1 - k);
    EXPECT_NEAR(piece.length_m, 200 + 2 * more - 2 * (k + 0.5) * width * std::tan(0.5 * turn), 1e-3);
  }
}

// Zhou fig. 8 on a rectangle of 100 × 12 m, w = 4, with a block over the middle track: beside it (case 1),
// beside and into the next track (case 2: goes on), across (case 3: two pieces).
TEST(RecursiveTracks, KnowTheThreeCasesOfObstacles) {
  Polygon body{{{0, 0}, {100, 0}, {100, 12}, {0, 12}}, {{{40, 4}, {40, 9}, {60, 9}, {60, 4}}}};
  const LaidTracks tracks = zhou_tracks({{0, 0}, {100, 0}}, 4, {body}, 0);
  ASSERT_EQ(tracks.pieces.size(), 4u);
  const auto on_track = [&](int track) {
    return std::count_if(tracks.pieces.begin(), tracks.pieces.end(),
                         [track](const LaidPiece& piece) { return piece.track == track; });
  };
  EXPECT_EQ(on_track(-1), 1);
  EXPECT_EQ(on_track(-2), 2);
  EXPECT_EQ(on_track(-3), 1);
  double whole = 0;
  for (const LaidPiece& piece : tracks.pieces) whole += piece.length_m;
  EXPECT_NEAR(whole, 100 + 80 + 100, 1e-3);
}

// A gap as wide as three tracks does not end the map.
TEST(RecursiveTracks, GoOnBeyondLandThatIsNotTheirs) {
  const Region body{{{{0, 0}, {100, 0}, {100, 8}, {0, 8}}, {}},
                    {{{0, 20}, {100, 20}, {100, 28}, {0, 28}}, {}}};
  const LaidTracks tracks = zhou_tracks({{0, 0}, {100, 0}}, 4, body, 0);
  ASSERT_EQ(tracks.pieces.size(), 4u);
  EXPECT_EQ(tracks.pieces.front().track, -7);
  EXPECT_EQ(tracks.pieces.back().track, -1);
}

// An arm of 108 × 8 m runs into one of 20 × 100 m, tracks along both. The third to fifth have their first
// edge in the second arm only: 10, 6 and 2 m of it. 4 m on that edge is gone, and what is left goes on
// straight into the first arm, across which the remaining tracks work it again, all 108 × 8 m of it.
TEST(RecursiveTracks, WorkAnArmAgainOnceItsEdgeIsGone) {
  const Polygon body{{{-100, 0}, {-100, -8}, {8, -8}, {8, -100}, {28, -100}, {28, 0}}, {}};
  const LaidTracks tracks = zhou_tracks({{-100, 0}, {28, 0}, {28, -100}}, 4, {body}, 0);
  ASSERT_EQ(tracks.pieces.size(), 5u + 27u);
  const double lengths[] = {126 + 98, 122 + 94, 10 + 90, 6 + 86, 2 + 82};
  for (std::size_t k = 0; k < tracks.pieces.size(); ++k)
    EXPECT_NEAR(tracks.pieces[k].length_m, k < 5 ? lengths[k] : 8, 1e-3) << k;
}

// Zhou algorithm 1: along a straight line the same as strips that end where nothing is left to cover.
TEST(RecursiveTracks, OfAStraightLineAreStraightStrips) {
  int compared = 0;
  for (unsigned seed = 1; seed <= 60; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> reach(40, 120), angle(0, 2 * kPi);
    Polygon field;
    for (int i = 0; i < 9; ++i) {
      const double q = reach(random);
      field.outer.push_back({q * std::cos(2 * kPi * i / 9), q * std::sin(2 * kPi * i / 9)});
    }
    field.holes.push_back({{-12, -9}, {-10, 9}, {11, 12}, {14, -8}});
    const double heading = angle(random), width = 5;
    const Point along{std::cos(heading), std::sin(heading)};
    const LaidTracks recursive = zhou_tracks({{1, 2}, Point{1, 2} + 30 * along}, width, {field}, 0);
    const StripGrid grid{TrackFrame(Direction::along({0, 0}, along)),
                         TrackFrame(Direction::along({0, 0}, along)).to_track(Point{1, 2}).x, width};
    const LaidTracks straight =
        cut_pieces(straight_tracks(grid, grid.frame.to_track(Region{field}).front(), {},
                                   end_criterion(EndRule::kCover, Objective{}, width)),
                   0);
    ASSERT_EQ(recursive.pieces.size(), straight.pieces.size());
    double a_m = 0, b_m = 0;
    for (std::size_t i = 0; i < straight.pieces.size(); ++i) {
      a_m += recursive.pieces[i].length_m;
      b_m += straight.pieces[i].length_m;
      ++compared;
    }
    EXPECT_NEAR(a_m, b_m, 0.01);
  }
  EXPECT_GT(compared, 1000);
}

}  // namespace tramline::zhou_tracks_test
