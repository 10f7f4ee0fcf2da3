#include "tramline/cost/piece_overlap.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace tramline {
namespace {

const Direction kEast = Direction::along({0, 0}, {1, 0});
const Direction kNorth = Direction::along({0, 0}, {0, 1});
constexpr double kWidth = 4;

// A rectangle whose right end runs back by a metre for each metre up: (100, 0) to (92, 8). Swaths that cover
// it reach to where their lower edges end, and pass the end by a triangle of 4 by 4 m each.
TEST(PieceOverlap, IsTheWedgeBeyondAnObliqueEnd) {
  const Region body{{{{0, 0}, {100, 0}, {92, 8}, {0, 8}}, {}}};
  const std::vector<TrackPiece> pieces{{{0, 2}, {100, 2}, 0, 0}, {{96, 6}, {0, 6}, 0, 1}};
  const std::vector<double> found = overlap_by_piece(body, {{body[0], kEast}}, pieces, kWidth);
  ASSERT_EQ(found.size(), 2u);
  EXPECT_NEAR(found[0], 8, 1e-9);
  EXPECT_NEAR(found[1], 8, 1e-9);
}

// An L of two arms. The swaths of the lower arm end with it. Of the upper arm one begins 2 m early, on 8 m²
// of the lower arm, and one ends 1 m late, on 4 m² beyond the body.
struct Ell {
  Region body{{{{0, 0}, {20, 0}, {20, 8}, {8, 8}, {8, 20}, {0, 20}}, {}}};
  std::vector<Subfield> subfields{{{{{0, 0}, {20, 0}, {20, 8}, {0, 8}}, {}}, kEast},
                                  {{{{0, 8}, {8, 8}, {8, 20}, {0, 20}}, {}}, kNorth}};
  TrackPiece low{{0, 2}, {20, 2}, 0, 0}, middle{{20, 6}, {0, 6}, 0, 1};
  TrackPiece left{{2, 6}, {2, 20}, 1, 0}, right{{6, 21}, {6, 8}, 1, 1};
};

TEST(PieceOverlap, OfTwoSwathsTheLaterOneHasIt) {
  const Ell l;
  const std::vector<double> lower_first =
      overlap_by_piece(l.body, l.subfields, {l.low, l.middle, l.left, l.right}, kWidth);
  const std::vector<double> upper_first =
      overlap_by_piece(l.body, l.subfields, {l.left, l.right, l.low, l.middle}, kWidth);
  const double expected_lower[] = {0, 0, 8, 4}, expected_upper[] = {0, 4, 0, 8};
  ASSERT_EQ(lower_first.size(), 4u);
  ASSERT_EQ(upper_first.size(), 4u);
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_NEAR(lower_first[i], expected_lower[i], 1e-9) << i;
    EXPECT_NEAR(upper_first[i], expected_upper[i], 1e-9) << i;
  }
}

// Half a circle of radius 10 m off the line and away: the arc's swath is a half ring, and a piece that was
// there before takes the 4 by 4 m from it in which it crosses its straight part.
TEST(PieceOverlap, KnowsDetours) {
  const Region body{{{{0, -50}, {100, -50}, {100, 50}, {0, 50}}, {}}};
  TrackPiece round{{0, 0}, {100, 0}, 0, 0};
  Detour detour;
  detour.path = {{{30, 0}, {40, 10}, 0.1},
                 {{40, 10}, {50, 20}, -0.1},
                 {{50, 20}, {60, 10}, -0.1},
                 {{60, 10}, {70, 0}, 0.1}};
  round.detours = {detour};
  const TrackPiece across{{20, -50}, {20, 50}, 1, 0}, through{{50, -50}, {50, 40}, 1, 1};
  const std::vector<Subfield> subfields{{body[0], kEast}, {body[0], kNorth}};
  const double alone = overlap_by_piece(body, subfields, {round}, kWidth)[0];
  EXPECT_NEAR(alone, 0, 1e-9);
  EXPECT_NEAR(overlap_by_piece(body, subfields, {across, round}, kWidth)[1], 16, 1e-9);
  // At its top the arc runs between the circles of 8 and 12 m about (50, 10): over 4 m of x the difference of
  // their heights.
  const auto under = [](double r) { return 2 * std::sqrt(r * r - 4) + r * r * std::asin(2 / r); };
  EXPECT_NEAR(overlap_by_piece(body, subfields, {through, round}, kWidth)[1], under(12) - under(8), 1e-9);
}

}  // namespace
}  // namespace tramline
