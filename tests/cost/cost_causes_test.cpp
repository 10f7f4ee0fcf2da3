#include "tramline/cost/cost_causes.h"

#include <gtest/gtest.h>

#include "support/box_ring.h"
#include "tramline/cost/strip_tally.h"
#include "tramline/tracks/strip_origin.h"

namespace tramline::cost_causes_test {

constexpr double kWidth = 3;
// Edges lie on strip lines up to the width tolerance.
constexpr double kTolerance_m2 = 1e-3;

const Direction kNorth = Direction::clockwise_from_north(Angle::degrees(0));
const Direction kEast = Direction::clockwise_from_north(Angle::degrees(90));

using testing_support::box;

/// Ground with all tracks cut; strips lie from the first of the longest edges.
struct Laid {
  std::vector<Subfield> subfields;
  Region hard{};      ///< holes of the subfields
  Region passable{};  ///< part of the subfields
  EndRule rule = EndRule::kCheapest;
  double min_length_m = 0;

  std::vector<TrackFamily> families{};
  std::vector<LaidTracks> tracks{};
  Region body{};
  Tally tally{};

  CostCauses causes(const Objective& objective = {}) {
    double body_m2 = -area(passable);
    for (const Subfield& subfield : subfields) {
      const StripGrid grid = strip_grids(subfield, kWidth).front();
      const Polygon turned = grid.frame.to_track(Region{subfield.shape}).front();
      families.push_back(straight_tracks(grid, turned,
                                         {grid.frame.to_track(hard), grid.frame.to_track(passable), {}},
                                         end_criterion(rule, objective, kWidth)));
      tracks.push_back(cut_pieces(families.back(), min_length_m));
      body_m2 += area(subfield.shape);
    }
    tally = tally_of(subfields, tracks, body_m2);
    return causes_of({subfields, families, tracks, body, {}, passable, tally}, objective);
  }
};

struct Expected {
  Cause cause;
  double overlap_m2;
  double uncovered_m2;
  int count = 0;
};

/// A second subfield; stops and further subfields cost the same.
const Expected kOneMore{Cause::kSubfields, 0, 0, 1};

/// These parts, at prices 0.02, 0.10, 1.00, 5 and 5, and nothing else but turns.
void expect_causes(const CostCauses& causes, const std::vector<Expected>& expected, int turns) {
  CostCauses wanted{};
  for (const Expected& each : expected)
    wanted.parts[static_cast<std::size_t>(each.cause)] = {
        each.overlap_m2, each.uncovered_m2, each.count,
        0.02 * each.overlap_m2 + 0.10 * each.uncovered_m2 + 5 * each.count};
  wanted.parts[static_cast<std::size_t>(Cause::kTurns)] = {0, 0, turns, 1.00 * turns};
  for (std::size_t i = 0; i < kCauseCount; ++i) {
    SCOPED_TRACE(name(static_cast<Cause>(i)));
    EXPECT_NEAR(causes.parts[i].overlap_m2, wanted.parts[i].overlap_m2, kTolerance_m2);
    EXPECT_NEAR(causes.parts[i].uncovered_m2, wanted.parts[i].uncovered_m2, kTolerance_m2);
    EXPECT_EQ(causes.parts[i].count, wanted.parts[i].count);
    EXPECT_NEAR(causes.parts[i].cost, wanted.parts[i].cost, kTolerance_m2);
  }
}

// 31 = 10·3 + 1: the eleventh strip has 1 of 3 m inside, the same all along.
TEST(CostCauses, AStripThatIsNotFullLiesAlongASide) {
  Laid left{{{{box(0, 0, 31, 100), {}}, kNorth}}};
  left.rule = EndRule::kCentre;
  expect_causes(left.causes(), {{Cause::kSides, 0, 100}}, 9);
  Laid driven{{{{box(0, 0, 31, 100), {}}, kNorth}}};
  driven.rule = EndRule::kCover;
  expect_causes(driven.causes(), {{Cause::kSides, 200, 0}}, 10);
}

/// 30 m wide, ten strips of 3 m; the northern edge rises by `slope`.
Laid trapezium(double slope) {
  return {{{{{{0, 0}, {30, 0}, {30, 200 + 30 * slope}, {0, 200}}, {}}, kNorth}}};
}

// With f = 0.10/(0.02 + 0.10) a wedge of ½w²·cot φ costs f² of it in overlap and (1 − f)² in
// land left.
TEST(CostCauses, WedgesWhereAnEdgeCrossesTheTracksAreRowEnds) {
  for (const double slope : {0.25, 1.0, 3.0}) {
    SCOPED_TRACE(slope);
    const double wedges_m2 = 10 * 0.5 * kWidth * kWidth * slope, f = 0.10 / 0.12;
    expect_causes(trapezium(slope).causes(),
                  {{Cause::kRowEnds, f * f * wedges_m2, (1 - f) * (1 - f) * wedges_m2}}, 9);
  }
}

TEST(CostCauses, AnEdgeThatTakesMoreThanFourWidthsToPassThroughAStripIsASide) {
  const double wedges_m2 = 10 * 0.5 * kWidth * kWidth * 5, f = 0.10 / 0.12;
  expect_causes(trapezium(5).causes(), {{Cause::kSides, f * f * wedges_m2, (1 - f) * (1 - f) * wedges_m2}},
                9);
}

// A notch in the eastern side, 1 m deep: strips end beside it or not, it lies along them.
TEST(CostCauses, ANotchInASideIsASide) {
  const Ring notched{{0, 0}, {30, 0}, {30, 40}, {29, 40}, {29, 60}, {30, 60}, {30, 100}, {0, 100}};
  expect_causes(Laid{{{{notched, {}}, kNorth}}}.causes(), {{Cause::kSides, 1 * 20, 0}}, 9);
}

/// Two parts of a rectangle of 60 × 90 m with a border at 45° between them, both driven north.
Laid parted(EndRule rule) {
  Laid out{{{{{{0, 0}, {30, 0}, {60, 30}, {60, 90}, {0, 90}}, {}}, kNorth},
            {{{{30, 0}, {60, 0}, {60, 30}}, {}}, kNorth}}};
  out.rule = rule;
  return out;
}

// Ten strips meet the border from either side, with wedges of 4.5 m². One of them is all there is of its
// strip: `inside` does not drive it.
TEST(CostCauses, WhatSubfieldsOverlapAndLeaveAtTheirBorderIsASeam) {
  expect_causes(parted(EndRule::kCover).causes(), {{Cause::kSeams, 2 * 10 * 4.5, 0}, kOneMore}, 29);
  expect_causes(parted(EndRule::kInside).causes(), {{Cause::kSeams, 0, 2 * 10 * 4.5}, kOneMore}, 28);
  // What the one leaves the other covers, so that the halves of a strip fit together.
  expect_causes(parted(EndRule::kCentre).causes(), {kOneMore}, 29);
}

// One leg of 31 × 60 m is driven north, the other, 59 × 31 m, east. Each has an eleventh strip with 1 m of
// ground. That of the northern leg works 2 m of the other leg for 31 m, and beyond the field for 29 m; that
// of the other lies beyond the field for all of 59 m.
TEST(CostCauses, AnLShapeHasASeamWhereItsLegsMeet) {
  Laid laid{{{{box(0, 0, 31, 60), {}}, kNorth}, {{box(31, 0, 90, 31), {}}, kEast}}};
  laid.rule = EndRule::kCover;
  expect_causes(laid.causes(), {{Cause::kSeams, 2 * 31, 0}, {Cause::kSides, 2 * 29 + 2 * 59, 0}, kOneMore},
                21);
}

// A diamond of 3 × 3 m fills the second strip for 3 m: two stops, and its four corners are left.
TEST(CostCauses, APondThatCutsAStripLeavesItsCornersToTheStops) {
  const Ring pond{{4.5, 48.5}, {6, 50}, {4.5, 51.5}, {3, 50}};
  Laid laid{{{{box(0, 0, 30, 100), {reversed(pond)}}, kNorth}}};
  laid.hard = {{pond, {}}};
  expect_causes(laid.causes(), {{Cause::kStops, 0, 3 * 3 - 4.5, 2}}, 10);
}

// The same across all strips: the ends at a waterway of 3 m that rises at 45° leave or overlap nothing but
// wedges, 4.5 m² on either bank of each strip.
TEST(CostCauses, WedgesAtAPassableObstacleAreRowEnds) {
  Laid laid{{{{box(0, 0, 30, 100), {}}, kNorth}}};
  laid.passable = {{{{0, 30}, {30, 60}, {30, 63}, {0, 33}}, {}}};
  expect_causes(laid.causes(), {{Cause::kRowEnds, 0, 10 * 2 * 4.5}}, 9);
}

// Ten strips of 100 m, and a step of 3 m at the end of the second: with a least length of 101 m only that
// strip is driven.
TEST(CostCauses, PiecesTooShortToDriveAreACauseOfTheirOwn) {
  const Ring stepped{{0, 0}, {30, 0}, {30, 100}, {6, 100}, {6, 103}, {3, 103}, {3, 100}, {0, 100}};
  Laid laid{{{{stepped, {}}, kNorth}}};
  laid.min_length_m = 101;
  expect_causes(laid.causes(), {{Cause::kShortPieces, 0, 9 * 300}}, 0);
}

TEST(CostCauses, SumToTheTallyWhateverRounds) {
  Laid laid = trapezium(1);
  const CostCauses causes = laid.causes();
  double overlap_m2 = 0, uncovered_m2 = 0, sum = 0;
  for (const CausePart& part : causes.parts) {
    overlap_m2 += part.overlap_m2;
    uncovered_m2 += part.uncovered_m2;
    sum += part.cost;
  }
  EXPECT_NEAR(overlap_m2, laid.tally.overlap_m2, 1e-10);
  EXPECT_NEAR(uncovered_m2, laid.tally.uncovered_m2, 1e-10);
  EXPECT_NEAR(sum, cost(Objective{}, laid.tally), 1e-10);
  EXPECT_NEAR(causes.overlap_rounding_m2, 0, 1e-6);
  EXPECT_NEAR(causes.uncovered_rounding_m2, 0, 1e-6);
}

}  // namespace tramline::cost_causes_test
