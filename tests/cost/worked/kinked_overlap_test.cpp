#include "tramline/cost/worked/kinked_overlap.h"

#include <gtest/gtest.h>

#include "tramline/geometry/path/kinked_line.h"

namespace tramline::kinked_overlap_test {

const Region kPlenty{{{{-20, -20}, {20, -20}, {20, 20}, {-20, 20}}, {}}};

TrackPiece piece_along(const std::vector<Point>& line) {
  TrackPiece out{line.front(), line.back()};
  out.curve = polyline_path(line);
  return out;
}

// Two swaths of 2 × 10 m cross at right angles, 4 m² in common; 1 m of either end of one lies beyond the
// body.
TEST(KinkedOverlap, OfTwoSwathsTheLaterOneHasIt) {
  const Region body{{{{0, 0}, {10, 0}, {10, 8}, {0, 8}}, {}}};
  const TrackPiece along = piece_along({{0, 4}, {10, 4}}), across = piece_along({{5, -1}, {5, 9}});
  const std::vector<double> along_first = overlap_by_kinked_piece(body, {along, across}, 2);
  EXPECT_NEAR(along_first[0], 0, 1e-9);
  EXPECT_NEAR(along_first[1], 8, 1e-9);
  const std::vector<double> across_first = overlap_by_kinked_piece(body, {across, along}, 2);
  EXPECT_NEAR(across_first[0], 4, 1e-9);
  EXPECT_NEAR(across_first[1], 4, 1e-9);
}

// A mitred right angle has the area w·L, and the next track beside it, legs 2 m longer, only touches it.
// Without the mitres 4 m² of the inner square would be worked twice.
TEST(KinkedOverlap, KnowsMitres) {
  const TrackPiece inner = piece_along({{0, 0}, {10, 0}, {10, -10}}),
                   outer = piece_along({{0, 2}, {12, 2}, {12, -10}});
  for (const double overlap_m2 : overlap_by_kinked_piece(kPlenty, {inner, outer}, 2))
    EXPECT_NEAR(overlap_m2, 0, 1e-9);
}

// Back along itself 1 m beside, w = 2: of 42 m² 31 are worked once.
TEST(KinkedOverlap, CountsWhatOneSwathWorksTwice) {
  const TrackPiece back = piece_along({{0, 0}, {10, 0}, {10, 1}, {0, 1}});
  EXPECT_NEAR(overlap_by_kinked_piece(kPlenty, {back}, 2)[0], 42 - 31, 1e-9);
}

// A piece along a straight line has no curve of its own.
TEST(KinkedOverlap, KnowsStraightPieces) {
  const Region body{{{{0, 0}, {10, 0}, {10, 8}, {0, 8}}, {}}};
  EXPECT_NEAR(overlap_by_kinked_piece(body, {{{-1, 7.5}, {10, 7.5}}}, 2)[0], 22 - 15, 1e-9);
}

}  // namespace tramline::kinked_overlap_test
