// Plans for missed ground, by hand. Field: a square of 100 m unless said otherwise; w = 6.

#include "tramline/planner/repair_plan.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "support/refusals.h"
#include "tramline/geometry/boolean.h"

namespace tramline {
namespace {

using testing_support::mentions;
using testing_support::refusal_of;

constexpr double kWidth_m = 6;

Ring box(double min_x, double min_y, double max_x, double max_y) {
  return {{min_x, min_y}, {max_x, min_y}, {max_x, max_y}, {min_x, max_y}};
}

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

RepairPlan repaired(const Field& field, const std::vector<Ring>& rings, RepairTerms terms = {}) {
  terms.machine.width_m = kWidth_m;
  Region missed;
  for (const Ring& ring : rings) missed.push_back({ring, {}});
  return repair_plan(field, gaps_of(rings), missed, terms, 1, 1, {});
}

/// How far swaths reach beyond a box, m.
double beyond(const Plan& plan, const Box& within) {
  const Box reach = bounds(swaths(plan));
  return std::max({within.min_x - reach.min_x, within.min_y - reach.min_y, reach.max_x - within.max_x,
                   reach.max_y - within.max_y});
}

// 12 × 30 m are two swaths of 30 m side by side: nothing is worked in vain, and there is one turn.
TEST(RepairPlan, ARectangleInTheMiddleIsWorkedAlong) {
  const RepairPlan done = repaired(square(), {box(40, 30, 52, 60)});
  const Tally& tally = done.plan.tally;
  EXPECT_EQ(tally.pieces, 2);
  EXPECT_EQ(tally.turns, 1);
  EXPECT_EQ(tally.stops, 0);
  EXPECT_NEAR(tally.track_length_m, 60, 1e-6);
  EXPECT_NEAR(tally.overlap_m2, 0, 1e-3);
  EXPECT_NEAR(tally.uncovered_m2, 0, 1e-3);
  EXPECT_NEAR(done.plan.cost, 1.00, 1e-3);
  EXPECT_NEAR(done.missed_before_m2, 360, 1e-9);
  EXPECT_NEAR(done.missed_after_m2, 0, 1e-3);
  EXPECT_EQ(done.taken, 1);
  EXPECT_NEAR(area(done.plan.worked), 1e4 - 360, 1e-3);
}

// A strip of 1 × 50 m between two passes: one swath over it, (6 − 1)·50 m² of worked ground again. By the
// prices alone nine pieces of 1 m across it would cost 3.60 and not 10.
TEST(RepairPlan, AThinGapIsWorkedByOneSwathAlongIt) {
  const RepairPlan done = repaired(square(), {box(40, 20, 41, 70)});
  const Tally& tally = done.plan.tally;
  EXPECT_EQ(tally.pieces, 1);
  EXPECT_NEAR(tally.track_length_m, 50, 1e-6);
  EXPECT_NEAR(tally.overlap_m2, 250, 1e-3);
  EXPECT_NEAR(tally.uncovered_m2, 0, 1e-3);
  EXPECT_NEAR(std::abs(done.plan.pieces[0].end.y - done.plan.pieces[0].start.y), 50, 1e-6);
}

// 2 m along the western boundary: the only swath that covers them and stays in the field has its middle at
// x = 3.
TEST(RepairPlan, AtTheBoundaryASwathStaysInTheField) {
  const RepairPlan done = repaired(square(), {box(0, 20, 2, 60)});
  ASSERT_EQ(done.plan.tally.pieces, 1);
  EXPECT_NEAR(done.plan.pieces[0].start.x, 3, 1e-5);
  EXPECT_NEAR(done.plan.pieces[0].end.x, 3, 1e-5);
  EXPECT_NEAR(done.plan.tally.overlap_m2, 40 * 4, 1e-2);
  EXPECT_NEAR(done.plan.tally.uncovered_m2, 0, 1e-2);
  EXPECT_LE(beyond(done.plan, {0, 0, 100, 100}), 1e-5);
  EXPECT_EQ(done.plan.settings.boundary, EdgeKind::kHard);
}

/// With a nook in the west, 1.8 m wide and 10 m deep. All that gets in of a swath 6 m wide is a corner: the
/// right-angled triangle over the mouth, 1.8²/4 = 0.81 m² at most.
Field with_nook() {
  Field field = square();
  field.outer = {{0, 0}, {100, 0}, {100, 100}, {0, 100}, {0, 49.8}, {-10, 49.8}, {-10, 48}, {0, 48}};
  return field;
}

TEST(RepairPlan, ANookNarrowerThanTheMachineIsListed) {
  const RepairPlan done = repaired(with_nook(), {box(40, 30, 52, 60), box(-10, 48, 0, 49.8)});
  EXPECT_EQ(done.gaps, 2);
  EXPECT_EQ(done.taken, 1);
  ASSERT_EQ(done.unreachable.size(), 1u);
  EXPECT_EQ(done.unreachable[0].number, 2);
  EXPECT_NEAR(done.unreachable[0].area_m2, 18, 1e-9);
  EXPECT_NEAR(done.unreachable[0].at.x, -5, 1e-9);
  EXPECT_TRUE(mentions(done.unreachable[0].why, "cannot enter"));
  EXPECT_NEAR(area(done.plan.body), 360, 1e-6) << "the nook is not taken on";
  EXPECT_NEAR(done.missed_after_m2, 18, 1e-3);
}

// The nook with 2 m of the field before it: those are worked, 18 m² are left of the gap.
TEST(RepairPlan, OfAGapThatReachesIntoANookTheRestIsListed) {
  const RepairPlan done = repaired(with_nook(), {box(-10, 48, 2, 49.8)});
  EXPECT_EQ(done.taken, 1);
  ASSERT_EQ(done.unreachable.size(), 1u);
  EXPECT_NEAR(done.unreachable[0].area_m2, 18, 1e-3);
  EXPECT_NEAR(done.plan.tally.uncovered_m2, 18, 1e-3);
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
  EXPECT_EQ(done.taken, 1);
  ASSERT_EQ(done.ignored.size(), 1u);
  EXPECT_EQ(done.ignored[0].number, 2);
  EXPECT_NEAR(done.missed_after_m2, 0.9, 1e-3);
}

// Two squares of 12 m in one line, 30 m apart: each needs two swaths, and each swath goes on from one to the
// other with the work off. Four pieces, two crossings, one turn.
TEST(RepairPlan, GapsInLineAreJoined) {
  const RepairPlan done = repaired(square(), {box(20, 10, 32, 22), box(20, 52, 32, 64)});
  EXPECT_EQ(done.plan.tally.pieces, 4);
  EXPECT_EQ(done.plan.tally.crossings, 2);
  EXPECT_EQ(done.plan.tally.turns, 1);
  EXPECT_NEAR(done.plan.tally.overlap_m2, 0, 1e-3);
  EXPECT_NEAR(done.plan.cost, 1.00, 1e-3);
}

// The second is 3 m to the side in one direction and 45 in the other: on a common grid either has a swath
// half of which is overlap, 12·3 m² on either side, which costs 2.88 and saves at most two turns, 0.90.
TEST(RepairPlan, GapsOutOfStepAreNotJoined) {
  const RepairPlan done = repaired(square(), {box(20, 10, 32, 22), box(23, 55, 35, 67)});
  EXPECT_EQ(done.plan.tally.pieces, 4);
  EXPECT_EQ(done.plan.tally.crossings, 0);
  EXPECT_EQ(done.plan.tally.turns, 3);
  EXPECT_NEAR(done.plan.tally.overlap_m2, 0, 1e-3);
}

// Where overlap costs next to nothing, the turns that a common grid saves decide.
TEST(RepairPlan, GapsOutOfStepAreJoinedWhereTurnsAreDear) {
  RepairTerms terms;
  terms.objective = {0.0001, 0.1, 0.45, 5};
  const RepairPlan done = repaired(square(), {box(20, 10, 32, 22), box(23, 55, 35, 67)}, terms);
  EXPECT_EQ(done.plan.tally.turns, 2);
  EXPECT_GT(done.plan.tally.crossings, 0);
  EXPECT_GT(done.plan.tally.overlap_m2, 30);
}

// Two thin gaps side by side, 2 m apart, lie under one swath.
TEST(RepairPlan, OneSwathWorksTwoGapsSideBySide) {
  const RepairPlan done = repaired(square(), {box(40, 20, 41, 70), box(43, 20, 44, 70)});
  EXPECT_EQ(done.plan.tally.pieces, 1);
  EXPECT_NEAR(done.plan.tally.overlap_m2, 6 * 50 - 100, 1e-3);
}

// A pond between two gaps in line: the machine does not drive through it, and both pieces that end at it are
// stops.
TEST(RepairPlan, APondBetweenTwoGapsIsNotCrossed) {
  Field field = square();
  field.obstacles = {{{box(18, 30, 34, 40), {}}, ObstacleKind::kObstacle, "pond"}};
  const RepairPlan done = repaired(field, {box(20, 10, 26, 30), box(20, 40, 26, 60)});
  EXPECT_EQ(done.plan.tally.pieces, 2);
  EXPECT_EQ(done.plan.tally.crossings, 0);
  EXPECT_EQ(done.plan.tally.turns, 1);
  EXPECT_EQ(done.plan.tally.stops, 2);
}

// An arm of an L each way: neither is worked across.
TEST(RepairPlan, AnAngleIsWorkedAlongBothArms) {
  const RepairPlan done = repaired(square(), {{{20, 20}, {70, 20}, {70, 22}, {22, 22}, {22, 70}, {20, 70}}});
  EXPECT_EQ(done.plan.tally.pieces, 2);
  EXPECT_NEAR(done.plan.tally.uncovered_m2, 0, 1e-3);
  EXPECT_LT(done.plan.tally.track_length_m, 101);
}

}  // namespace
}  // namespace tramline
