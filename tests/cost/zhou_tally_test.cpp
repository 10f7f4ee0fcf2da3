#include "tramline/cost/zhou_tally.h"

#include <gtest/gtest.h>

#include "tramline/geometry/path/kinked_line.h"

namespace tramline::zhou_tally_test {

LaidPiece piece_along(const std::vector<Point>& line) {
  LaidPiece out;
  out.path = polyline_path(line);
  out.length_m = out.to = length(out.path);
  return out;
}

/// Σ w·L − overlap + uncovered against the body, as follows from Zhou §2.3.5.
void expect_identity(const Tally& tally, double body_m2) {
  EXPECT_NEAR(tally.worked_m2, body_m2 - tally.uncovered_m2 + tally.overlap_m2, 1e-9);
}

// Two swaths of 2 × 10 m cross at right angles on a body of 10 × 8 m: 40 m² are worked, 36 of them once, 32
// of these in the body, 1 m of either end of the second lying beyond it.
TEST(ZhouTally, CountsGroundOnce) {
  const Region body{{{{0, 0}, {10, 0}, {10, 8}, {0, 8}}, {}}};
  LaidTracks tracks;
  tracks.pieces = {piece_along({{0, 4}, {10, 4}}), piece_along({{5, -1}, {5, 9}})};
  const Tally tally = zhou_tally(tracks, 2, body).tally;
  EXPECT_NEAR(tally.worked_m2, 40, 1e-9);
  EXPECT_NEAR(tally.overlap_m2, 40 - 32, 1e-4);
  EXPECT_NEAR(tally.uncovered_m2, 80 - 32, 1e-4);
  EXPECT_EQ(tally.pieces, 2);
  EXPECT_EQ(tally.turns, 1);
  expect_identity(tally, 80);
}

// A right angle is mitred: as an L of 2 m wide, both legs 10 m, it has the area 40 and no overlap.
TEST(ZhouTally, KnowsMitres) {
  const Region body{{{{-20, -20}, {20, -20}, {20, 20}, {-20, 20}}, {}}};
  LaidTracks tracks;
  tracks.pieces = {piece_along({{0, 0}, {10, 0}, {10, 10}})};
  const Tally tally = zhou_tally(tracks, 2, body).tally;
  EXPECT_NEAR(tally.overlap_m2, 0, 1e-4);
  EXPECT_NEAR(tally.uncovered_m2, 1600 - 40, 1e-4);
}

// Back along itself 1 m beside, w = 2: legs of 10 and 10 m and 1 m between them. All ends flat (the middle
// leg is too short for two mitres on one side): 10 × 3 m and 2 × 1 less what the legs have of it: 1 × 1.
TEST(ZhouTally, CountsWhatOneSwathWorksTwice) {
  const Region body{{{{-20, -20}, {20, -20}, {20, 20}, {-20, 20}}, {}}};
  LaidTracks tracks;
  tracks.pieces = {piece_along({{0, 0}, {10, 0}, {10, 1}, {0, 1}})};
  const Tally tally = zhou_tally(tracks, 2, body).tally;
  EXPECT_NEAR(tally.worked_m2, 42, 1e-9);
  EXPECT_NEAR(tally.overlap_m2, 42 - 31, 1e-4);
  expect_identity(tally, 1600);
}

}  // namespace tramline::zhou_tally_test
