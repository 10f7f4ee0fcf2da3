#include "tramline/tracks/curved_tracks.h"
#include "tramline/tracks/straight_tracks.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "tramline/geometry/path/extended_line.h"
#include "tramline/model/objective.h"
#include "tramline/tracks/laid_pieces.h"

namespace tramline::curved_tracks_test {

constexpr double kPi = std::numbers::pi;
constexpr double kWidth = 3;

Polygon box(double x0, double y0, double x1, double y1) {
  return {{{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}}, {}};
}

LaidTracks lay(const Path& reference, const CurvedGround& ground, EndRule rule, double min_length = 0) {
  const Box reach = ground.body.grid().bounds();
  const Path whole = extended(reference, reach.grown(1)).path;
  const StripRange range = tracks_over(whole, reach, kWidth);
  return curved_pieces(parallel_family(whole, range.first, range.last, {6, kWidth}), kWidth, ground,
                       end_criterion(rule, Objective{}, kWidth), min_length);
}

// A straight reference north through a field with slanting ends: straight strips.
TEST(CurvedPieces, OfAStraightReferenceAreStraightStrips) {
  const Polygon field{{{0, 0}, {31, 11}, {28, 120}, {-4, 90}}, {}};
  const Path reference = straight_path({1, 20}, {1, 60});
  for (const EndRule rule : {EndRule::kCentre, EndRule::kCover, EndRule::kInside, EndRule::kCheapest}) {
    const LaidTracks curved = lay(reference, {EdgeIndex({field})}, rule);
    const StripGrid grid{TrackFrame(Direction::along({0, 0}, {0, 1})), 1, kWidth};
    const LaidTracks straight = cut_pieces(straight_tracks(grid, {grid.frame.to_track(field.outer), {}}, {},
                                                           end_criterion(rule, Objective{}, kWidth)),
                                           0);
    ASSERT_EQ(curved.pieces.size(), straight.pieces.size()) << name(rule);
    for (std::size_t i = 0; i < curved.pieces.size(); ++i) {
      const LaidPiece& a = curved.pieces[i];
      const LaidPiece& b = straight.pieces[i];
      EXPECT_EQ(a.track, b.track);
      EXPECT_NEAR(a.path.front().from.y, b.from, 1e-9) << name(rule);
      EXPECT_NEAR(a.path.back().to.y, b.to, 1e-9) << name(rule);
      EXPECT_NEAR(a.path.front().from.x, 1 + (a.track + 0.5) * kWidth, 1e-9);
      EXPECT_NEAR(a.inside_m2, b.inside_m2, 1e-8);
    }
  }
}

// Arcs about the origin across the strip 0 ≤ x ≤ 40: the centre line of radius q runs from angle
// acos(40/q), where it enters, to 90 degrees.
TEST(CurvedPieces, EndWhereArcsMeetStraightEdges) {
  const Path reference{{{100, 0}, {0, 100}, 0.01}};
  const CurvedGround ground{EdgeIndex({box(0, 1, 40, 140)})};
  const LaidTracks tracks = lay(reference, ground, EndRule::kCentre);
  int checked = 0;
  for (const LaidPiece& piece : tracks.pieces) {
    const double q = 100 + (piece.track + 0.5) * kWidth;
    if (q < 60 || q > 135) continue;
    ++checked;
    EXPECT_NEAR(piece.length_m, q * std::asin(40 / q), 1e-6) << q;
  }
  EXPECT_EQ(checked, 25);
}

TEST(CurvedPieces, StopBeforeAnythingHard) {
  const Path reference = straight_path({0, 0}, {0, 100});
  CurvedGround ground{EdgeIndex({box(0, 0, 12, 100)}), EdgeIndex({box(4, 40, 5, 50)})};
  const LaidTracks tracks = lay(reference, ground, EndRule::kCentre, 45);
  ASSERT_EQ(tracks.pieces.size(), 4u);
  EXPECT_NEAR(tracks.pieces[1].path.front().from.y, 50, 1e-9);
  EXPECT_TRUE(tracks.pieces[1].stop_at_from);
  EXPECT_FALSE(tracks.pieces[1].stop_at_to);
  ASSERT_EQ(tracks.dropped.size(), 1u) << "40 m before the obstacle";
  EXPECT_TRUE(tracks.dropped[0].stop_at_to);
  ground.field = EdgeIndex({box(0, 0, 11, 100)});
  EXPECT_EQ(lay(reference, ground, EndRule::kCentre).pieces.size(), 4u) << "the last swath would stick out";
}

TEST(CurvedPieces, GoRoundAClosedTrackInOnePiece) {
  const double r = 30;
  Path circle{
      {{r, 0}, {0, r}, 1 / r}, {{0, r}, {-r, 0}, 1 / r}, {{-r, 0}, {0, -r}, 1 / r}, {{0, -r}, {r, 0}, 1 / r}};
  const std::vector<FamilyTrack> family{{0, {circle, true}}};
  // Without its left part.
  const LaidTracks tracks = curved_pieces(family, kWidth, {EdgeIndex({box(0, -50, 50, 50)})},
                                          end_criterion(EndRule::kCentre, Objective{}, kWidth), 0);
  ASSERT_EQ(tracks.pieces.size(), 1u);
  EXPECT_NEAR(tracks.pieces[0].length_m, kPi * r, 1e-6);
  EXPECT_NEAR(tracks.pieces[0].path.front().from.y, -r, 1e-6);
}

// All of it: the piece has two ends, hardly apart.
TEST(CurvedPieces, AllRoundEndBeforeTheyBegin) {
  const double r = 30;
  Path circle{
      {{r, 0}, {0, r}, 1 / r}, {{0, r}, {-r, 0}, 1 / r}, {{-r, 0}, {0, -r}, 1 / r}, {{0, -r}, {r, 0}, 1 / r}};
  const LaidTracks tracks = curved_pieces({{0, {circle, true}}}, kWidth, {EdgeIndex({box(-50, -50, 50, 50)})},
                                          end_criterion(EndRule::kCentre, Objective{}, kWidth), 0);
  ASSERT_EQ(tracks.pieces.size(), 1u);
  EXPECT_NEAR(tracks.pieces[0].length_m, 2 * kPi * r, 1e-4);
  const double apart_m = distance(tracks.pieces[0].path.front().from, tracks.pieces[0].path.back().to);
  EXPECT_GT(apart_m, 0);
  EXPECT_LT(apart_m, 1e-4);
}

// A wave of arcs from south to north, and boxes on both sides of it: every place of a box lies on one of the
// tracks, by the distance from chords of the wave, and those there are reach the box but for what the
// sixteenths of it leave out. The wave swings by 20 − √(400 − 100) m to either side of x = 0.
TEST(TracksOver, AreThoseThatReachPlacesOfTheBox) {
  constexpr double kSwing = 3;
  Path wave;
  for (int i = -6; i < 6; ++i)
    wave.push_back({{0, 20.0 * i}, {0, 20.0 * (i + 1)}, i % 2 == 0 ? 0.05 : -0.05});
  const std::vector<Point> line = chords(wave, 1e-3);
  const auto scanned_m = [&line](Point p) {
    double out = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i + 1 < line.size(); ++i)
      out = std::min(out, distance_to_segment(p, line[i], line[i + 1]));
    return p.x > 0 ? out : -out;
  };
  for (const Box& reach : {Box{5, -40, 60, 30}, Box{-70, -35, -20, 60}, Box{-30, 0, 45, 20}}) {
    const StripRange range = tracks_over(wave, reach, kWidth);
    double low = std::numeric_limits<double>::infinity(), high = -low;
    for (int i = 0; i <= 32; ++i)
      for (int j = 0; j <= 32; ++j) {
        const Point p{reach.min_x + reach.width() * i / 32, reach.min_y + reach.height() * j / 32};
        if (std::abs(p.x) < kSwing) continue;
        low = std::min(low, scanned_m(p));
        high = std::max(high, scanned_m(p));
      }
    const double slack = 0.5 * std::hypot(reach.width(), reach.height()) / 16 + kWidth;
    EXPECT_LE(range.first * kWidth, low + 0.01);
    EXPECT_GE(range.first * kWidth, low - slack);
    EXPECT_GE((range.last + 1) * kWidth, high - 0.01);
    EXPECT_LE((range.last + 1) * kWidth, high + slack);
  }
}

}  // namespace tramline::curved_tracks_test
