// Plans for missed ground, by hand. Field: a square of 100 m unless said otherwise; w = 6.

#include "tramline/planner/repair/repair_plan.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "support/box_ring.h"
#include "support/refusals.h"
#include "tramline/geometry/polygon/boolean.h"

namespace tramline::repair_plan_test {

using testing_support::mentions;
using testing_support::refusal_of;

constexpr double kWidth_m = 6;

using testing_support::box;

Field square() {
  Field field;
  field.id = "square";
  field.outer = box(0, 0, 100, 100);
  return field;
}

std::vector<Gap> gaps_of(const std::vector<Ring>& rings) {
  std::vector<Gap> out;
  for (const Ring& ring : rings)
    out.push_back(
        {static_cast<int>(out.size()) + 1, {ring, {}}, signed_area(ring), midpoint(ring[0], ring[2]), 0});
  return out;
}

/// Per m² of overlap and missed land, turn and stop.
constexpr Objective kPrices{0.02, 0.10, 1.00, 5};

/// A drive to and fro at work, in that direction, all over the square.
std::vector<DrivenLine> driven(Point along) {
  std::vector<DrivenLine> out;
  for (double at = kWidth_m / 2; at < 100; at += kWidth_m) {
    const Point from = at * Point{along.y, along.x};
    out.push_back({static_cast<int>(out.size()), {from, from + 100.0 * along}, 0, 0});
  }
  return out;
}
const Point kNorth{0, 1}, kEast{1, 0};

RepairPlan repaired(const Field& field, const std::vector<Ring>& rings, RepairTerms terms = {{}, kPrices},
                    const std::vector<DrivenLine>& drive = driven(kNorth)) {
  terms.machine.width_m = kWidth_m;
  Region missed;
  for (const Ring& ring : rings) missed.push_back({ring, {}});
  return repair_plan(field, gaps_of(rings), missed, drive, terms, 1, 1, {});
}

/// How far swaths reach beyond a box, m.
double beyond(const Plan& plan, const Box& within) {
  const Box reach = bounds(swaths(plan));
  return std::max({within.min_x - reach.min_x, within.min_y - reach.min_y, reach.max_x - within.max_x,
                   reach.max_y - within.max_y});
}

// 12 × 30 m are two swaths of 30 m side by side: nothing is worked in vain; there is one turn, and the way
// there counts as another. Left as it is the gap costs 36.00.
TEST(RepairPlan, ARectangleInTheMiddleIsWorkedAlong) {
  const RepairPlan done = repaired(square(), {box(40, 30, 52, 60)});
  const Tally& tally = done.plan.tally;
  EXPECT_EQ(tally.pieces, 2);
  EXPECT_EQ(tally.turns, 1);
  EXPECT_EQ(tally.stops, 0);
  EXPECT_NEAR(tally.track_length_m, 60, 1e-6);
  EXPECT_NEAR(tally.overlap_m2, 0, 1e-3);
  EXPECT_NEAR(tally.uncovered_m2, 0, 1e-3);
  EXPECT_NEAR(done.missed_before_m2, 360, 1e-9);
  EXPECT_NEAR(done.missed_after_m2, 0, 1e-3);
  EXPECT_EQ(done.worked_gaps, 1);
  EXPECT_NEAR(area(done.plan.worked), 1e4 - 360, 1e-3);
  EXPECT_NEAR(done.cost_if_left, 36, 1e-6);
  EXPECT_NEAR(done.cost_of_passes, 2, 1e-3);
  EXPECT_NEAR(done.cost_after, 2, 1e-3);
}

// The same gap lies across the drive: it is worked across, in five swaths of 12 m, because the machine drove
// so. The way there and four turns cost 5; along it they would have cost 2.
TEST(RepairPlan, KeepsToTheDirectionDriven) {
  const RepairPlan done = repaired(square(), {box(40, 30, 52, 60)}, {{}, kPrices}, driven(kEast));
  EXPECT_EQ(done.plan.tally.pieces, 5);
  EXPECT_NEAR(done.cost_of_passes, 5, 1e-3);
  for (const TrackPiece& piece : done.plan.pieces) EXPECT_NEAR(piece.start.y, piece.end.y, 1e-9);
}

// Driven north in the west and east in the east: a gap in each is worked as the machine drove there.
TEST(RepairPlan, EachGapKeepsToTheDirectionDrivenThere) {
  std::vector<DrivenLine> drive;
  for (double at = 3; at < 50; at += kWidth_m) drive.push_back({0, {{at, 0}, {at, 100}}, 0, 0});
  for (double at = 3; at < 100; at += kWidth_m) drive.push_back({0, {{50, at}, {100, at}}, 0, 0});
  const RepairPlan done =
      repaired(square(), {box(10, 30, 22, 60), box(65, 30, 95, 42)}, {{}, kPrices}, drive);
  int north = 0, east = 0;
  for (const TrackPiece& piece : done.plan.pieces) {
    const bool in_west = piece.start.x < 50;
    EXPECT_NEAR(in_west ? piece.start.x - piece.end.x : piece.start.y - piece.end.y, 0, 1e-9);
    ++(in_west ? north : east);
  }
  EXPECT_EQ(north, 2);
  EXPECT_EQ(east, 2);
}

// A strip of 1 × 50 m between two passes costs 5.00 left as it is; the pass over it works 250 m² again, which
// costs 5.00 too, and a turn. One of 3 × 50 m costs 15.00, and the pass 4.00.
TEST(RepairPlan, APassThatCostsMoreThanItsGapIsNotMade) {
  const RepairPlan done = repaired(square(), {box(40, 20, 41, 70), box(80, 20, 83, 70)});
  EXPECT_EQ(done.worked_gaps, 1);
  ASSERT_EQ(done.not_worth.size(), 1u);
  EXPECT_EQ(done.not_worth[0].number, 1);
  EXPECT_NEAR(done.not_worth[0].area_m2, 50, 1e-9);
  EXPECT_TRUE(mentions(done.not_worth[0].why, "costs 6.00"));
  EXPECT_TRUE(mentions(done.not_worth[0].why, "wins back 5.00"));
  EXPECT_NEAR(done.cost_if_left, 20, 1e-6);
  EXPECT_NEAR(done.cost_of_passes, 0.02 * 150 + 1, 1e-3);
  EXPECT_NEAR(done.cost_after, 0.02 * 150 + 1 + 0.10 * 50, 1e-3);
}

TEST(RepairPlan, WhereNoPassIsWorthItThatIsSaidWithThePrices) {
  const std::string why = refusal_of([] { repaired(square(), {box(40, 20, 41, 70)}); });
  EXPECT_TRUE(mentions(why, "worth a pass"));
  EXPECT_TRUE(mentions(why, "5.00"));
  EXPECT_TRUE(mentions(why, "6.00"));
}

// 2 m along the western boundary: the only swath that covers them and stays in the field has its middle at
// x = 3. It costs 0.02 · 160 = 3.20 and wins back 8.00.
TEST(RepairPlan, AtTheBoundaryASwathStaysInTheField) {
  const RepairPlan done = repaired(square(), {box(0, 20, 2, 60)});
  ASSERT_EQ(done.plan.tally.pieces, 1);
  EXPECT_NEAR(done.plan.pieces[0].start.x, 3, 1e-4);
  EXPECT_NEAR(done.plan.pieces[0].end.x, 3, 1e-4);
  EXPECT_NEAR(done.plan.tally.overlap_m2, 40 * 4, 1e-2);
  EXPECT_NEAR(done.plan.tally.uncovered_m2, 0, 1e-2);
  EXPECT_LE(beyond(done.plan, {0, 0, 100, 100}), 1e-5);
  EXPECT_EQ(done.plan.settings.boundary, EdgeKind::kHard);
}

/// With a nook in the west, 1.8 m wide and 10 m deep.
Field with_nook() {
  Field field = square();
  field.outer = {{0, 0}, {100, 0}, {100, 100}, {0, 100}, {0, 49.8}, {-10, 49.8}, {-10, 48}, {0, 48}};
  return field;
}

TEST(RepairPlan, ANookNarrowerThanTheMachineIsListed) {
  const RepairPlan done = repaired(with_nook(), {box(40, 30, 52, 60), box(-10, 48, 0, 49.8)});
  EXPECT_EQ(done.gaps, 2);
  EXPECT_EQ(done.worked_gaps, 1);
  ASSERT_EQ(done.unreachable.size(), 1u);
  EXPECT_EQ(done.unreachable[0].number, 2);
  EXPECT_NEAR(done.unreachable[0].area_m2, 18, 1e-9);
  EXPECT_NEAR(done.unreachable[0].at.x, -5, 1e-9);
  EXPECT_TRUE(mentions(done.unreachable[0].why, "cannot enter"));
  EXPECT_NEAR(area(done.plan.body), 360, 1e-6) << "the nook is not taken on";
  EXPECT_NEAR(done.missed_after_m2, 18, 1e-3);
}

TEST(RepairPlan, OnlyANookIsNothingToPlanFor) {
  const std::string why = refusal_of([] { repaired(with_nook(), {box(-10, 48, 0, 49.8)}); });
  EXPECT_TRUE(mentions(why, "square"));
  EXPECT_TRUE(mentions(why, "--min-area"));
}

TEST(RepairPlan, NothingMissedIsBadInput) {
  EXPECT_TRUE(mentions(refusal_of([] { repaired(square(), {}); }), "nothing of the field"));
}

TEST(RepairPlan, AFieldNotWorkedAtAllIsNothingToRepair) {
  EXPECT_TRUE(mentions(refusal_of([] { repaired(square(), {box(0, 0, 100, 100)}); }), "tramline plan"));
}

TEST(RepairPlan, SmallGapsAreIgnoredAndListed) {
  const RepairPlan done = repaired(square(), {box(40, 30, 52, 60), box(70, 70, 71, 70.9)});
  EXPECT_EQ(done.worked_gaps, 1);
  ASSERT_EQ(done.ignored.size(), 1u);
  EXPECT_EQ(done.ignored[0].number, 2);
  EXPECT_NEAR(done.missed_after_m2, 0.9, 1e-3);
}

// Two squares of 12 m in one line, 30 m apart: each needs two swaths, and each swath goes on from one to the
// other with the work off. Four pieces, two crossings, one turn, and the way there.
TEST(RepairPlan, GapsInLineAreJoined) {
  const RepairPlan done = repaired(square(), {box(20, 10, 32, 22), box(20, 52, 32, 64)});
  EXPECT_EQ(done.plan.tally.pieces, 4);
  EXPECT_EQ(done.plan.tally.crossings, 2);
  EXPECT_EQ(done.plan.tally.turns, 1);
  EXPECT_NEAR(done.plan.tally.overlap_m2, 0, 1e-3);
  EXPECT_NEAR(done.cost_of_passes, 2, 1e-3);
}

// The second is 3 m to the side. Three lines do for both: those over the second take half of the first along
// on one of them, 36 m² again, and the third takes what is left of the first, half of it in vain, 36 m². With
// the two turns that is 2 + 1.44; four lines flush with the gaps cost three turns, 3.
TEST(RepairPlan, GapsOutOfStepAreWorkedByThemselvesWhereThatIsCheaper) {
  const RepairPlan done = repaired(square(), {box(20, 10, 32, 22), box(23, 55, 35, 67)});
  EXPECT_NEAR(done.plan.tally.uncovered_m2, 0, 1e-3);
  EXPECT_EQ(done.plan.tally.turns, 3);
  EXPECT_NEAR(done.plan.tally.overlap_m2, 0, 1e-3);
}

// Where overlap costs next to nothing, the turn that is saved decides.
TEST(RepairPlan, GapsOutOfStepAreJoinedWhereTurnsAreExpensive) {
  const RepairPlan done = repaired(square(), {box(20, 10, 32, 22), box(23, 55, 35, 67)},
                                   {{}, {0.0001, 0.1, 1, 5}, EndRule::kCover});
  EXPECT_EQ(done.plan.tally.turns, 2);
  EXPECT_GT(done.plan.tally.crossings, 0);
  EXPECT_GT(done.plan.tally.overlap_m2, 30);
}

// Two gaps side by side, 1 m apart, are under one swath: 2.5 and 2.5 of its 6 m.
TEST(RepairPlan, OneSwathWorksTwoGapsSideBySide) {
  const RepairPlan done = repaired(square(), {box(40, 20, 42.5, 70), box(43.5, 20, 46, 70)});
  EXPECT_EQ(done.plan.tally.pieces, 1);
  EXPECT_NEAR(done.plan.tally.overlap_m2, 50, 1e-3);
}

// A pond between two gaps in line: the machine does not drive through it, and a piece that ends at it is a
// stop. A stop costs 5.00, and each gap 30 m long wins back 18.00.
TEST(RepairPlan, APondBetweenTwoGapsIsNotCrossed) {
  Field field = square();
  field.obstacles = {{{box(18, 40, 34, 50), {}}, ObstacleKind::kObstacle, "pond"}};
  const RepairPlan done = repaired(field, {box(20, 10, 26, 40), box(20, 50, 26, 80)});
  EXPECT_EQ(done.plan.tally.pieces, 2);
  EXPECT_EQ(done.plan.tally.crossings, 0);
  EXPECT_EQ(done.plan.tally.turns, 1);
  EXPECT_EQ(done.plan.tally.stops, 2);
}

// Driven both ways: either arm of an L is worked along.
TEST(RepairPlan, AnAngleIsWorkedAlongBothArms) {
  std::vector<DrivenLine> both = driven(kNorth);
  for (const DrivenLine& line : driven(kEast)) both.push_back(line);
  const RepairPlan done =
      repaired(square(), {{{20, 20}, {70, 20}, {70, 24}, {24, 24}, {24, 70}, {20, 70}}}, {{}, kPrices}, both);
  EXPECT_EQ(done.plan.tally.pieces, 2);
  EXPECT_NEAR(done.plan.tally.uncovered_m2, 0, 1e-3);
  EXPECT_LT(done.plan.tally.track_length_m, 101);
}

}  // namespace tramline::repair_plan_test
