// End rules, hard edges, crossings and short pieces on scenes with areas known by hand.
// Tracks run north, strips start at x = 0.

#include "tramline/tracks/laid_pieces.h"
#include "tramline/tracks/straight_tracks.h"
#include "tramline/tracks/tolerances.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace tramline::laid_pieces_test {

constexpr double kWidth = 3;

StripGrid north_grid() { return {TrackFrame(Direction::clockwise_from_north(Angle::degrees(0))), 0, kWidth}; }

Polygon box(double x0, double y0, double x1, double y1) {
  return {{{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}}, {}};
}

struct Sums {
  double overlap = 0, uncovered = 0;
  int pieces = 0;
};

Sums sums_of(const LaidTracks& tracks, const Polygon& subfield) {
  Sums out;
  double inside = 0;
  for (const LaidPiece& piece : tracks.pieces) {
    out.overlap += kWidth * (piece.to - piece.from) - piece.inside_m2;
    inside += piece.inside_m2;
    ++out.pieces;
  }
  out.uncovered = area(subfield) - inside;
  return out;
}

LaidTracks lay(const Polygon& subfield, EndRule rule, const TurnedGround& ground = {}, double min_length = 6,
               const Objective& objective = {}) {
  return cut_pieces(straight_tracks(north_grid(), subfield, ground, end_criterion(rule, objective, kWidth)),
                    min_length);
}

// An edge at angle φ to the tracks makes a wedge of ½w²cot φ at every row end; a row
// that ends at fraction f of the run has o = wedge·f², u = wedge·(1 − f)². Here φ = 45° and w = 3:
// wedge 4.5 m², ten rows, two ends each.
const Polygon kParallelogram{{{0, 0}, {30, 30}, {30, 130}, {0, 100}}, {}};
constexpr double kWedge = 4.5;
/// Twenty row ends of 3 m, each off by the width tolerance of 10 micrometres at 45°.
constexpr double kRowEnds = 20 * 3 * kWidthTolerance;

TEST(EndRules, OnAParallelogram) {
  struct Case {
    EndRule rule;
    double fraction;
  };
  const Objective prices;  // 0.02 and 0.10: f* = 0.10/0.12
  for (const Case& c : {Case{EndRule::kCentre, 0.5}, Case{EndRule::kCover, 1.0}, Case{EndRule::kInside, 0.0},
                        Case{EndRule::kCheapest, 0.10 / 0.12}}) {
    const Sums sums = sums_of(lay(kParallelogram, c.rule, {}, 6, prices), kParallelogram);
    EXPECT_EQ(sums.pieces, 10) << name(c.rule);
    EXPECT_NEAR(sums.overlap, 20 * kWedge * c.fraction * c.fraction, kRowEnds) << name(c.rule);
    EXPECT_NEAR(sums.uncovered, 20 * kWedge * (1 - c.fraction) * (1 - c.fraction), kRowEnds) << name(c.rule);
  }
}

// Over 3 m of a row an edge at 45° crosses it: what is cut off at one end by 5 m is a wedge and 2 m of the
// whole width, and what is left lies inside, but for the wedge at the other end.
TEST(CutTo, LeavesThePieceBetweenTwoPositions) {
  const TrackFamily family =
      straight_tracks(north_grid(), kParallelogram, {}, end_criterion(EndRule::kCover, {}, kWidth));
  for (const LaidPiece& piece : cut_pieces(family, 6).pieces) {
    const auto track = std::ranges::find(family.tracks, piece.track, &Track::index);
    ASSERT_NE(track, family.tracks.end());
    const LaidPiece late = cut_to(*track, piece, piece.from + 5, piece.to);
    EXPECT_EQ(late.to, piece.to);
    EXPECT_NEAR(late.length_m, piece.length_m - 5, 1e-9);
    EXPECT_NEAR(late.inside_m2, kWidth * late.length_m - kWedge, 1e-4);
    EXPECT_NEAR(piece.inside_m2 - late.inside_m2, kWedge + 2 * kWidth, 1e-4);
    const LaidPiece middle = cut_to(*track, piece, piece.from + 5, piece.to - 7);
    EXPECT_NEAR(middle.inside_m2, kWidth * middle.length_m, 1e-9);
    EXPECT_FALSE(middle.stop_at_from || middle.stop_at_to);
  }
}

TEST(EndRules, CheapestHalvesTheRunWhenNothingCosts) {
  const Objective free{0, 0, 1, 0};
  const Sums sums = sums_of(lay(kParallelogram, EndRule::kCheapest, {}, 6, free), kParallelogram);
  EXPECT_NEAR(sums.overlap, 20 * kWedge / 4, 1e-9);
}

// Legs of 60 m: row k is 60 − 3(k + ½) long; rows 18 and 19 (4.5 and 1.5 m) are shorter than 2w and
// their land, a triangle with legs of 6 m, stays uncovered.
TEST(EndRules, OnATriangleWithTheShortRowsDropped) {
  const Polygon triangle{{{0, 0}, {60, 0}, {0, 60}}, {}};
  const LaidTracks tracks = lay(triangle, EndRule::kCentre);
  const Sums sums = sums_of(tracks, triangle);
  EXPECT_EQ(sums.pieces, 18);
  EXPECT_EQ(tracks.dropped.size(), 2u);
  EXPECT_NEAR(sums.overlap, 18 * kWedge / 4, 1e-6);
  EXPECT_NEAR(sums.uncovered, 18 * kWedge / 4 + 18, 1e-6);
}

TEST(HardEdges, CutTheWholeWidthOverTheObstaclesExtent) {
  // Versleijen fig. 20: a diamond of 2 × 4 m in the middle of strip 1 cuts that strip from y = 48 to 52.
  Polygon field = box(0, 0, 9, 100);
  const Ring diamond{{4.5, 48}, {5.5, 50}, {4.5, 52}, {3.5, 50}};
  field.holes = {reversed(diamond)};
  for (const EndRule rule : {EndRule::kCentre, EndRule::kCover, EndRule::kInside, EndRule::kCheapest}) {
    const LaidTracks tracks = lay(field, rule, {{{diamond, {}}}, {}, {}});
    ASSERT_EQ(tracks.pieces.size(), 4u) << name(rule);
    EXPECT_NEAR(tracks.pieces[1].to, 48, 1e-4);
    EXPECT_NEAR(tracks.pieces[2].from, 52, 1e-4);
    EXPECT_TRUE(tracks.pieces[1].stop_at_to);
    EXPECT_TRUE(tracks.pieces[2].stop_at_from);
    EXPECT_FALSE(tracks.pieces[1].stop_at_from);
    EXPECT_FALSE(tracks.pieces[0].stop_at_to);
    EXPECT_FALSE(tracks.pieces[2].after_crossing);
    EXPECT_NEAR(sums_of(tracks, field).uncovered, 3 * 4 - 4, 1e-3);  // strip over 4 m less the diamond
  }
}

TEST(HardEdges, KeepEverySwathInsideAHardBoundary) {
  const TurnedGround ground{{}, {}, {kParallelogram}};
  const Sums sums = sums_of(lay(kParallelogram, EndRule::kCover, ground), kParallelogram);
  EXPECT_NEAR(sums.overlap, 0, 1e-3);
  EXPECT_NEAR(sums.uncovered, 20 * kWedge, 1e-3);
}

// The third strip sticks out of the field by a metre, into what has to be kept clear for 5 m.
TEST(HardEdges, CutSwathsThatStickOutIntoLandKeptClear) {
  TurnedGround ground;
  ground.beyond = {box(8, 40, 12, 45)};
  const LaidTracks tracks = lay(box(0, 0, 8, 100), EndRule::kCentre, ground);
  ASSERT_EQ(tracks.pieces.size(), 4u);
  EXPECT_NEAR(tracks.pieces[2].to, 40, 1e-9);
  EXPECT_NEAR(tracks.pieces[3].from, 45, 1e-9);
  EXPECT_FALSE(tracks.pieces[2].stop_at_to) << "nothing of the field blocks it";
  EXPECT_FALSE(tracks.pieces[3].after_crossing);
}

TEST(PassableObstacles, InterruptTheWorkWithoutAStop) {
  const Polygon field = box(0, 0, 6, 100);
  const TurnedGround ground{{}, {box(-5, 40, 20, 45)}, {}};
  const LaidTracks tracks = lay(field, EndRule::kCentre, ground);
  ASSERT_EQ(tracks.pieces.size(), 4u);
  EXPECT_NEAR(tracks.pieces[0].to, 40, 1e-9);
  EXPECT_NEAR(tracks.pieces[1].from, 45, 1e-9);
  EXPECT_TRUE(tracks.pieces[1].after_crossing);
  EXPECT_FALSE(tracks.pieces[0].stop_at_to);
  EXPECT_FALSE(tracks.pieces[0].after_crossing);
  EXPECT_FALSE(tracks.pieces[2].after_crossing) << "another strip";
}

TEST(PassableObstacles, ExemptWhatLiesBetweenTwoCrossings) {
  // Two waterways 2 m apart: the 2 m between them are driven although 2w = 6 m.
  const Polygon field = box(0, 0, 3, 100);
  const TurnedGround ground{{}, {box(-5, 10, 20, 12), box(-5, 14, 20, 16)}, {}};
  const LaidTracks tracks = lay(field, EndRule::kCentre, ground);
  ASSERT_EQ(tracks.pieces.size(), 3u);
  EXPECT_NEAR(tracks.pieces[1].from, 12, 1e-9);
  EXPECT_NEAR(tracks.pieces[1].to, 14, 1e-9);
  EXPECT_FALSE(tracks.pieces[0].after_crossing);
  EXPECT_TRUE(tracks.pieces[1].after_crossing);
  EXPECT_TRUE(tracks.pieces[2].after_crossing);
}

TEST(PassableObstacles, DoNotExemptWhatLiesBetweenTheEdgeAndACrossing) {
  const Polygon field = box(0, 0, 3, 100);
  const TurnedGround ground{{}, {box(-5, 4, 20, 6)}, {}};
  const LaidTracks tracks = lay(field, EndRule::kCentre, ground);
  ASSERT_EQ(tracks.pieces.size(), 1u);
  EXPECT_NEAR(tracks.pieces[0].from, 6, 1e-9);
  EXPECT_FALSE(tracks.pieces[0].after_crossing);
  EXPECT_EQ(tracks.dropped.size(), 1u);
}

// 5, 4 and 5 m with 2w = 6 m: the ends are dropped, and then nothing lies between two crossings.
TEST(PassableObstacles, LeaveNothingBetweenPiecesThatAreNotDriven) {
  const Polygon field = box(0, 0, 3, 20);
  const TurnedGround ground{{}, {box(-5, 5, 20, 8), box(-5, 12, 20, 15)}, {}};
  const LaidTracks tracks = lay(field, EndRule::kCentre, ground);
  EXPECT_TRUE(tracks.pieces.empty());
  EXPECT_EQ(tracks.dropped.size(), 3u);
}

TEST(PassableObstacles, MakeNoPiecesOfDust) {
  const Polygon field = box(0, 0, 3, 100);
  const TurnedGround ground{{}, {box(-5, 40, 20, 45), box(-5, 45.0000001, 20, 50)}, {}};
  const LaidTracks tracks = lay(field, EndRule::kCentre, ground, 0);
  EXPECT_EQ(tracks.pieces.size(), 2u);
  EXPECT_TRUE(tracks.dropped.empty());
}

TEST(PassableObstacles, DoNotExcuseAnObstacleInTheGap) {
  const Polygon field = box(0, 0, 3, 100);
  const TurnedGround ground{{box(1, 44, 2, 50)}, {box(-5, 40, 20, 45)}, {}};
  const LaidTracks tracks = lay(field, EndRule::kCentre, ground);
  ASSERT_EQ(tracks.pieces.size(), 2u);
  EXPECT_FALSE(tracks.pieces[1].after_crossing);
  EXPECT_TRUE(tracks.pieces[1].stop_at_from);
}

}  // namespace tramline::laid_pieces_test
