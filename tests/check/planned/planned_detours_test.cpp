// Plans that lead past obstacles hold.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "tramline/check/verify.h"
#include "tramline/geometry/path/path.h"
#include "tramline/geometry/polygon/boolean.h"
#include "tramline/planner/plan_field.h"

namespace tramline::planned_detours_test {

/// 120 × 90 m with a mast of 1.2 m radius, 64 corners, on the line of the eleventh track of 3 m.
Plan round_a_mast(Avoidance avoid, double radius_m, double room_m = -1) {
  Field field;
  field.id = "mast";
  field.outer = {{0, 0}, {120, 0}, {120, 90}, {0, 90}};
  Ring mast;
  for (int i = 0; i < 64; ++i) {
    const double angle = -2 * std::numbers::pi * i / 64;
    mast.push_back({60 + 1.2 * std::cos(angle), 31.5 + 1.2 * std::sin(angle)});
  }
  field.obstacles.push_back({{mast, {}}, ObstacleKind::kObstacle, "mast"});
  PlanSettings settings;
  settings.strategy = Strategy::kSweep;
  settings.avoid = avoid;
  settings.avoid_room_m = room_m;
  return plan_field(field, {"", 3, radius_m, -1}, weights_of(Scenario::kTurns), settings, 1);
}

// Versleijen fig. 18: the middle arc has the radius R + w/2 = 2.7 m, whatever the machine turns on. The
// verifier says so, and the plan holds.
TEST(PlannedPlans, FindTightMiddlesOfThePapersDetoursAndHold) {
  for (const double radius_m : {2.0, 6.0, 12.0}) {
    SCOPED_TRACE(radius_m);
    const Plan plan = round_a_mast(Avoidance::kPaper, radius_m);
    const check::Verdict verdict = check::verify(plan);
    EXPECT_TRUE(verdict.holds());
    ASSERT_EQ(verdict.findings.size(), radius_m > 2.7 ? 1u : 0u);
    if (verdict.findings.empty()) continue;
    EXPECT_EQ(verdict.findings.front().rule, check::Rule::kDrivable);
    EXPECT_NEAR(verdict.findings.front().amount, radius_m - 2.7, 1e-5);
    EXPECT_NEAR(distance(verdict.findings.front().at, {60, 31.5}), 0, 2.7);
  }
}

// The same arcs are violations where the plan promises that its tracks can be driven, and so are arcs at the
// ends of a paper's detour.
TEST(PlannedPlans, DoNotHoldWhereTightArcsAreNoPapers) {
  Plan plan = round_a_mast(Avoidance::kPaper, 6);
  plan.settings.avoid = Avoidance::kCheapest;
  EXPECT_FALSE(check::verify(plan).holds());
  Plan tighter_ends = round_a_mast(Avoidance::kPaper, 6);
  tighter_ends.machine.radius_m = 7;
  const check::Verdict verdict = check::verify(tighter_ends);
  EXPECT_FALSE(verdict.holds());
  EXPECT_EQ(verdict.violations.size(), 2u) << "arcs of 6 m before and behind";
}

// Versleijen fig. 50 (a): with half the width of room no detour of 2.7 m is driven.
TEST(PlannedPlans, CutWhereADetourHasNoRoom) {
  const Plan plan = round_a_mast(Avoidance::kPaper, 6, 1.5);
  EXPECT_TRUE(check::verify(plan).holds());
  ASSERT_EQ(plan.encounters.size(), 1u);
  EXPECT_EQ(plan.encounters.front().chosen, Passing::kCut);
  EXPECT_EQ(plan.encounters.front().left.why_not, "it would leave the track by more than it may");
  EXPECT_NE(round_a_mast(Avoidance::kPaper, 6, 2.71).encounters.front().chosen, Passing::kCut);
}

// A headland goes round the pole in the west alone: tracks end there. One goes round the pole in the east all
// the same, and past both: it is met with both.
TEST(PlannedPlans, HoldWhereADetourLeadsPastAnObstacleWithAHeadland) {
  Field field;
  field.id = "two poles";
  field.outer = {{0, 0}, {200, 0}, {200, 90}, {0, 90}};
  const Ring west{{62.5, 48.8}, {60.6, 50.6}, {58.1, 49.8}, {57.5, 47.2}, {59.4, 45.4}, {61.9, 46.2}};
  const Ring east{{73.6, 48.1}, {72.3, 49.3}, {70.7, 48.8}, {70.3, 47.1}, {71.6, 45.9}, {73.2, 46.4}};
  for (const Ring& ring : {west, east})
    field.obstacles.push_back({{ring, {}}, ObstacleKind::kObstacle, "pole"});
  PlanSettings settings;
  settings.obstacle_headlands = 1;
  const Plan plan = plan_field(field, {"", 6, 6, -1}, {}, settings, 1);
  std::size_t past_both = 0;
  for (const TrackPiece& piece : plan.pieces)
    for (const Detour& detour : piece.detours) past_both += detour.obstacles.size() == 2 ? 1 : 0;
  EXPECT_GE(past_both, 1U) << "the scene shows nothing";
  const check::Verdict verdict = check::verify(plan);
  for (const check::Violation& each : verdict.violations)
    ADD_FAILURE() << name(each.rule) << ": " << each.what;
}

/// A wall, hardly at an angle to the long sides of the field.
Field walled_field() {
  Field out;
  out.id = "walled";
  out.outer = {{0, 0}, {160, 0}, {160, 70}, {0, 70}};
  out.obstacles.push_back(
      {{{{50, 31}, {110, 36}, {110, 38}, {50, 33}}, {}}, ObstacleKind::kObstacle, "wall"});
  return out;
}

/// Between the line of a pass and a ring, m.
double line_to_ring_m(const Path& line, const Ring& ring) {
  double out = std::numeric_limits<double>::infinity();
  for (const PathSegment& segment : line)
    for (std::size_t i = 0; i < ring.size(); ++i)
      out = std::min(out, distance_to_edge(segment, ring[i], ring[(i + 1) % ring.size()]));
  return out;
}

Polygon swath_of(const TrackPiece& piece, double width_m) {
  const Point along = (1 / distance(piece.start, piece.end)) * (piece.end - piece.start);
  const Point beside = 0.5 * width_m * left_of(along);
  return {{piece.start - beside, piece.end - beside, piece.end + beside, piece.start + beside}, {}};
}

// A track that covers its ground up to an oblique edge runs on into the headland beyond, nearly as far as
// that is deep.
TEST(PlannedPlans, KeepTheClearanceBehindAHeadland) {
  constexpr double kWidth_m = 6, kClear_m = 0.8;
  const Field field = walled_field();
  const Polygon& wall = field.obstacles.front().shape;
  PlanSettings settings;
  settings.obstacle_headlands = 1;
  settings.end_rule = EndRule::kCover;
  settings.clearance_m = kClear_m;
  const Plan plan = plan_field(field, {"", kWidth_m, 4}, {}, settings, 1);
  for (const check::Violation& each : check::verify(plan).violations)
    ADD_FAILURE() << name(each.rule) << ": " << each.what;
  ASSERT_EQ(plan.headland.passes.size(), 1U);
  EXPECT_NEAR(line_to_ring_m(plan.headland.passes[0].path, wall.outer), kClear_m + 0.5 * kWidth_m, 1e-5);
  double nearest_m = kWidth_m;
  for (const TrackPiece& piece : plan.pieces)
    nearest_m = std::min(nearest_m, distance_between({swath_of(piece, kWidth_m)}, {wall}));
  EXPECT_GE(nearest_m, kClear_m - 1e-3);
  EXPECT_LT(nearest_m, kClear_m + 0.2 * kWidth_m) << "some track runs on";
}

}  // namespace tramline::planned_detours_test
