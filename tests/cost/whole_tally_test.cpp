// Tracks and headland passes together: by hand, and against polygon booleans.

#include "tramline/cost/whole_tally.h"

#include <gtest/gtest.h>

#include <cmath>

#include "properties/seeds.h"
#include "tramline/geometry/polygon/boolean.h"

namespace tramline::whole_tally_test {

constexpr double kWidth = 3;

Polygon box_polygon(double min_x, double min_y, double max_x, double max_y) {
  return {{{min_x, min_y}, {max_x, min_y}, {max_x, max_y}, {min_x, max_y}}, {}};
}

TrackPiece piece_between(Point start, Point end) {
  TrackPiece out;
  out.start = start;
  out.end = end;
  return out;
}

HeadlandPass pass_along(Path path) {
  HeadlandPass out;
  out.path = std::move(path);
  return out;
}

/// The tracks' own part of a tally.
Tally tally_of_tracks(const std::vector<TrackPiece>& pieces) {
  Tally out;
  for (const TrackPiece& piece : pieces) out.track_length_m += length(piece);
  out.worked_m2 = kWidth * out.track_length_m;
  out.pieces = static_cast<int>(pieces.size());
  out.stops = 2;
  out.turns = 7;
  return out;
}

// 20 m × 20 m, the lowest 3 m headland with one pass along it. Two swaths from the top run 1 m into that: of
// 60 + 2·3·18 m² worked, 2·3·1 m² are worked twice, and 20·17 − 2·3·17 m² are left.
TEST(WholeTally, CountsLandThatTracksAndPassesBothWorkOnce) {
  const std::vector<TrackPiece> pieces{piece_between({1.5, 20}, {1.5, 2}),
                                       piece_between({7.5, 2}, {7.5, 20})};
  Headland headland;
  headland.passes = {pass_along(straight_path({0, 1.5}, {20, 1.5}))};
  headland.ground = {box_polygon(0, 0, 20, 3)};
  headland.worked_m2 = 60;
  const Tally tracks = tally_of_tracks(pieces);
  const Tally whole = whole_tally(tracks, pieces, {box_polygon(0, 3, 20, 20)}, headland, kWidth);
  EXPECT_NEAR(whole.worked_m2, 60 + 108, 1e-9);
  EXPECT_NEAR(whole.overlap_m2, 6, 1e-9);
  EXPECT_NEAR(whole.uncovered_m2, 20 * 17 - 102, 1e-9);
  EXPECT_EQ(whole.track_length_m, tracks.track_length_m);
  EXPECT_EQ(whole.turns, 7);
  EXPECT_EQ(whole.stops, 2);
}

// A pass that the ground has more land than: the swaths in the headland cover what it leaves.
TEST(WholeTally, CountsHeadlandThatOnlyTracksWork) {
  const std::vector<TrackPiece> pieces{piece_between({1.5, 0}, {1.5, 20})};
  Headland headland;
  headland.passes = {pass_along(straight_path({5, 1.5}, {20, 1.5}))};
  headland.ground = {box_polygon(0, 0, 20, 3)};
  headland.worked_m2 = 45;
  const Tally whole =
      whole_tally(tally_of_tracks(pieces), pieces, {box_polygon(0, 3, 20, 20)}, headland, kWidth);
  EXPECT_NEAR(whole.overlap_m2, 0, 1e-9);
  EXPECT_NEAR(whole.uncovered_m2, 400 - 60 - 45, 1e-9);
}

TEST(WholeTally, WithoutHeadlandIsThatOfTheTracks) {
  const std::vector<TrackPiece> pieces{piece_between({1.5, 0}, {1.5, 20})};
  Tally tracks = tally_of_tracks(pieces);
  tracks.overlap_m2 = 1.25;
  tracks.uncovered_m2 = 2.5;
  const Tally whole = whole_tally(tracks, pieces, {box_polygon(0, 0, 20, 20)}, {}, kWidth);
  EXPECT_EQ(whole.overlap_m2, 1.25);
  EXPECT_EQ(whole.uncovered_m2, 2.5);
  EXPECT_EQ(whole.worked_m2, tracks.worked_m2);
}

// Swaths in all directions, curved ones and kinked ones among them, and passes with arcs.
TEST(WholeTally, OfAnyWorksIsThatOfBooleans) {
  testing::for_each_seed(40, [](std::mt19937_64& random, int number) {
    std::uniform_real_distribution<double> at(0, 40), bend(-0.1, 0.1);
    std::vector<TrackPiece> pieces;
    Headland headland;
    Region worked;
    for (int i = 0; i < 4; ++i) {
      TrackPiece piece = piece_between({at(random), at(random)}, {at(random), at(random)});
      if (distance(piece.start, piece.end) < 1) continue;
      if (i == 1 && number % 2 == 0) {
        const double most = 1 / distance(piece.start, piece.end);
        piece.curve = {{piece.start, piece.end, std::clamp(bend(random), -most, most)}};
      }
      if (i == 2 && number % 3 == 0) {
        const Point along = piece.end - piece.start;
        const Point middle = midpoint(piece.start, piece.end) + 0.2 * left_of(along);
        piece.curve = {{piece.start, middle, 0}, {middle, piece.end, 0}};
      }
      for (Ring& part : swath_parts(piece, kWidth)) worked.push_back({std::move(part), {}});
      pieces.push_back(std::move(piece));
    }
    const double y = at(random);
    headland.passes = {pass_along({{{0, y}, {20, y}, 0}, {{20, y}, {26, y + 6}, 1.0 / 6}}),
                       pass_along(straight_path({at(random), -1}, {at(random), 41}))};
    for (const HeadlandPass& pass : headland.passes) {
      worked.push_back({band(pass.path, kWidth), {}});
      headland.worked_m2 += kWidth * length(pass.path);
    }
    headland.ground = {box_polygon(0, 0, 40, 6)};
    const Region body{{{{0, 6}, {40, 6}, {40, 40}, {0, 40}}, {{{10, 15}, {12, 25}, {22, 20}}}}};
    const Tally tracks = tally_of_tracks(pieces);
    const Tally whole = whole_tally(tracks, pieces, body, headland, kWidth);
    const Region land = unite(body, headland.ground);
    const double useful = area(intersection(unite(worked), land));
    // Kinked swaths are worked by their cells, a wedge less at the inner side of a kink than on the outer.
    ASSERT_NEAR(whole.uncovered_m2, area(land) - useful, 0.01);
    ASSERT_NEAR(whole.overlap_m2, tracks.worked_m2 + headland.worked_m2 - useful, 0.01);
  });
}

}  // namespace tramline::whole_tally_test
