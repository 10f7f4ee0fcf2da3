#include "tramline/cost/worked/piece_overlap.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace tramline::piece_overlap_test {

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

const Region kField{{{{0, -50}, {100, -50}, {100, 50}, {0, 50}}, {}}};

// Two quarters and a half circle of radius 10 m, 4 m wide.
const double kDetour_m2 = kWidth * 20 * std::numbers::pi;
// At its top the detour runs round (50, 10) between 8 and 12 m. A swath from 18 to 22 m takes the cap of the
// larger circle that is more than 8 m above the centre.
const double kCap_m2 = 144 * std::acos(8.0 / 12) - 8 * std::sqrt(144.0 - 64);
// A swath from 14 to 18 m, more than 4 m above the centre, takes the next 4 m of that but for the cap of the
// smaller circle.
const double kBelowCap_m2 = 144 * std::acos(4.0 / 12) - 4 * std::sqrt(144.0 - 16) - kCap_m2 -
                            (64 * std::acos(4.0 / 8) - 4 * std::sqrt(64.0 - 16));

/// Of a curved family, along y = `at`, with half a circle of radius 10 m between two quarters, to the left or
/// to the right. Where it keeps to its track it overlaps nothing.
TrackPiece round_piece(double at, double left) {
  TrackPiece out{{0, at}, {100, at}};
  const auto y = [&](double up) { return at + left * up; };
  Detour detour;
  detour.path = {{{30, y(0)}, {40, y(10)}, left * 0.1},
                 {{40, y(10)}, {50, y(20)}, -left * 0.1},
                 {{50, y(20)}, {60, y(10)}, -left * 0.1},
                 {{60, y(10)}, {70, y(0)}, left * 0.1}};
  out.curve = {{{0, y(0)}, {30, y(0)}}};
  out.curve.insert(out.curve.end(), detour.path.begin(), detour.path.end());
  out.curve.push_back({{70, y(0)}, {100, y(0)}});
  out.detours = {detour};
  out.overlap_m2 = kDetour_m2;
  return out;
}

TrackPiece plain_piece(double at) {
  TrackPiece out{{0, at}, {100, at}};
  out.curve = straight_path(out.start, out.end);
  out.overlap_m2 = 0;
  return out;
}

void expect_overlaps(const std::vector<TrackPiece>& pieces, const std::vector<double>& expected) {
  const std::vector<double> found = overlap_by_piece(kField, {{kField[0], kEast}}, pieces, kWidth);
  ASSERT_EQ(found.size(), expected.size());
  for (std::size_t i = 0; i < found.size(); ++i) EXPECT_NEAR(found[i], expected[i], 1e-9) << i;
}

TEST(PieceOverlap, OfACurveIsItsOwnWhereNothingIsMet) {
  TrackPiece past_the_end = plain_piece(4);
  past_the_end.overlap_m2 = 7;
  expect_overlaps({plain_piece(0), past_the_end}, {0, 7});
  expect_overlaps({round_piece(0, 1)}, {0});
}

// Whoever comes later works in vain what they share.
TEST(PieceOverlap, OfACurveGoesToTheLaterOneInDrivingOrder) {
  const TrackPiece round = round_piece(0, 1), top = plain_piece(20), below = plain_piece(16);
  expect_overlaps({round, top, below}, {0, kCap_m2, kBelowCap_m2});
  expect_overlaps({top, below, round}, {0, 0, kCap_m2 + kBelowCap_m2});
  expect_overlaps({top, round, below}, {0, kCap_m2, kBelowCap_m2});
}

// From y = 40 another comes down on the first: their tops lie over one another. What two detours have in
// common is lost once, to the second, and a later swath loses all that either has of it, but not twice.
TEST(PieceOverlap, OfTwoDetoursAlongCurvesCountsOnce) {
  const TrackPiece up = round_piece(0, 1), down = round_piece(40, -1), between = plain_piece(20);
  // Above y = 20 the first detour has the cap of its larger circle that is more than 10 m above its centre;
  // the second has as much below, and what they share is both.
  const double above_m2 = 144 * std::acos(10.0 / 12) - 10 * std::sqrt(144.0 - 100), shared_m2 = 2 * above_m2;
  // Either cap reaches from 18 to 22 m, and so does the swath between: it holds all they share.
  const double either_m2 = 2 * kCap_m2 - shared_m2;
  expect_overlaps({up, down, between}, {0, shared_m2, either_m2});
  expect_overlaps({between, up, down}, {0, kCap_m2, kCap_m2});
  expect_overlaps({up, between, down}, {0, kCap_m2, kCap_m2});
}

// Below y = 12 alone there is anything to work: the detour's own half circle begins 2 m lower.
TEST(PieceOverlap, OfACurveKnowsTheBody) {
  const Region low{{{{0, -50}, {100, -50}, {100, 10}, {0, 10}}, {}}};
  EXPECT_NEAR(overlap_by_piece(low, {{low[0], kEast}}, {round_piece(0, 1)}, kWidth)[0], 0.5 * kDetour_m2,
              1e-9);
}

// The swath along y = 0 reaches up to y = 2. Of two straight swaths that come down from the north, 4 m wide,
// one ends 1 m below that, and one above.
TEST(PieceOverlap, OfACurveMeetsOtherSubfields) {
  const std::vector<Subfield> subfields{{kField[0], kEast, straight_path({-1, 0}, {101, 0})},
                                        {kField[0], kNorth}};
  const TrackPiece curved = plain_piece(0), down{{10, 40}, {10, 1}, 1, 0}, away{{20, 40}, {20, 3}, 1, 1};
  const std::vector<double> found = overlap_by_piece(kField, subfields, {curved, down, away}, kWidth);
  EXPECT_NEAR(found[0], 0, 1e-9);
  EXPECT_NEAR(found[1], 4, 1e-9);
  EXPECT_NEAR(found[2], 0, 1e-9);
  EXPECT_NEAR(overlap_by_piece(kField, subfields, {down, away, curved}, kWidth)[2], 4, 1e-9);
}

// Two subfields along curves that meet at x = 50. The first swath ends 2 m beyond the border: where nobody
// has been before that is no overlap, but the other subfield's swath comes and loses it.
TEST(PieceOverlap, OfACurveBeyondItsSubfieldGoesToTheLaterOneToo) {
  const Region body{{{{0, -2}, {100, -2}, {100, 2}, {0, 2}}, {}}};
  const Path line = straight_path({-1, 0}, {101, 0});
  const std::vector<Subfield> subfields{{{{{0, -2}, {50, -2}, {50, 2}, {0, 2}}, {}}, kEast, line},
                                        {{{{50, -2}, {100, -2}, {100, 2}, {50, 2}}, {}}, kEast, line}};
  TrackPiece first{{0, 0}, {52, 0}, 0, 0}, second{{50, 0}, {100, 0}, 1, 0};
  for (TrackPiece* piece : {&first, &second}) piece->curve = straight_path(piece->start, piece->end);
  first.overlap_m2 = 8;
  second.overlap_m2 = 0;
  const std::vector<double> there = overlap_by_piece(body, subfields, {first, second}, kWidth),
                            back = overlap_by_piece(body, subfields, {second, first}, kWidth);
  EXPECT_NEAR(there[0], 0, 1e-9);
  EXPECT_NEAR(there[1], 8, 1e-9);
  EXPECT_NEAR(back[0], 0, 1e-9);
  EXPECT_NEAR(back[1], 8, 1e-9);
}

}  // namespace tramline::piece_overlap_test
