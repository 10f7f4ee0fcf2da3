// Turns between tracks, the headlands that they need, stops, and what the verifier finds wrong with them.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <set>

#include "tramline/check/verify.h"
#include "tramline/geometry/error.h"
#include "tramline/planner/plan_field.h"
#include "tramline/route/order/skip_pattern.h"

namespace tramline::turning_test {

Field rectangle(double width_m, double height_m) {
  Field field;
  field.id = "rectangle";
  field.outer = {{0, 0}, {width_m, 0}, {width_m, height_m}, {0, height_m}};
  return field;
}

PlanSettings headlands_for_turns(int skip = 1) {
  PlanSettings settings;
  settings.headland_rule = HeadlandRule::kTurns;
  settings.turns = TurnPlanning::kTurns;
  settings.skip = skip;
  return settings;
}

int count(const Plan& plan, TurnState state) {
  return static_cast<int>(std::count_if(plan.turns.begin(), plan.turns.end(),
                                        [&](const PlannedTurn& turn) { return turn.state == state; }));
}

/// Passes at the ends of tracks that run east, on the edges from vertex 1 and from vertex 3.
std::pair<int, int> passes_at_ends(const Plan& plan) {
  return {plan.settings.headland_edges.at(1), plan.settings.headland_edges.at(3)};
}

// 400 × 250 m, w = 3, r = 6. The next track is 3 m away: an omega of r(π + 4 acos((r + s/2)/2r)) = 40.35 m,
// whose axle gets r + √(4r² − (r + s/2)²) = 15.37 m deep; with half the bar 16.87 m: six passes.
TEST(HeadlandsForTurns, AdjacentTracksNeedSixPasses) {
  const Plan plan = plan_field(rectangle(400, 250), {"", 3, 6}, {}, headlands_for_turns());
  EXPECT_EQ(passes_at_ends(plan), std::pair(6, 6));
  ASSERT_EQ(count(plan, TurnState::kFits), static_cast<int>(plan.turns.size()));
  const double omega_m = 6 * (std::numbers::pi + 4 * std::acos(7.5 / 12));
  for (const PlannedTurn& turn : plan.turns) {
    EXPECT_EQ(turn.manoeuvre.kind, ManoeuvreKind::kOmega);
    EXPECT_NEAR(length(turn.manoeuvre.path), omega_m, 1e-6);
  }
  EXPECT_EQ(plan.tally.stops, 0);
  const check::Verdict verdict = check::verify(plan);
  EXPECT_TRUE(verdict.holds()) << verdict.violations.front().what;
}

// Over 12 m = 2r it is half a circle, 6 m deep, and 7.5 m with half the bar: three passes.
TEST(HeadlandsForTurns, JumpsOfTwoRadiiNeedThree) {
  const Plan plan = plan_field(rectangle(400, 250), {"", 3, 6}, {}, headlands_for_turns(4));
  EXPECT_EQ(passes_at_ends(plan), std::pair(3, 3));
  EXPECT_EQ(count(plan, TurnState::kFits), static_cast<int>(plan.turns.size()));
  const check::Verdict verdict = check::verify(plan);
  EXPECT_TRUE(verdict.holds()) << verdict.violations.front().what;
}

// A fishtail is r deep, and 7.5 m with half the bar.
TEST(HeadlandsForTurns, ReversingNeedsThree) {
  Machine machine{"", 3, 6};
  machine.turning.reverse = true;
  const Plan plan = plan_field(rectangle(400, 250), machine, {}, headlands_for_turns());
  EXPECT_EQ(passes_at_ends(plan), std::pair(3, 3));
  EXPECT_EQ(count(plan, TurnState::kFits), static_cast<int>(plan.turns.size()));
  const check::Verdict verdict = check::verify(plan);
  EXPECT_TRUE(verdict.holds()) << verdict.violations.front().what;
}

// Half as deep as the omega needs: most turns lack room, and the plan says how much, 16.87 − 9 m or, leaning
// over, less.
TEST(Turns, WithoutRoomAreReported) {
  PlanSettings settings;
  settings.headlands = 3;
  settings.turns = TurnPlanning::kTurns;
  const Plan plan = plan_field(rectangle(100, 60), {"", 3, 6}, {}, settings);
  ASSERT_FALSE(plan.turns.empty());
  for (const PlannedTurn& turn : plan.turns) {
    if (turn.state != TurnState::kNoRoom) continue;
    EXPECT_GT(turn.missing_m, 0);
    EXPECT_LT(turn.missing_m, 7.9);
  }
  const check::Verdict verdict = check::verify(plan);
  EXPECT_TRUE(verdict.holds()) << verdict.violations.front().what;
}

// One pass of 3 m: a quarter turn needs 7.5 m, so there is no way off any track.
TEST(Stops, AreWhereNoTurnFits) {
  PlanSettings settings;
  settings.turns = TurnPlanning::kTurns;
  settings.headlands = 1;
  const Plan shallow = plan_field(rectangle(100, 60), {"", 3, 6}, {}, settings);
  EXPECT_EQ(shallow.tally.stops, 2 * shallow.tally.pieces);
  settings.headlands = 3;  // 9 m
  EXPECT_EQ(plan_field(rectangle(100, 60), {"", 3, 6}, {}, settings).tally.stops, 0);
}

// A pond across the tracks. Without a headland its neighbours back out; three passes round it give them room.
TEST(Stops, AnObstacleWithAHeadlandDeepEnoughHasNone) {
  Field field = rectangle(200, 100);
  field.obstacles = {{{{{90, 40}, {110, 40}, {110, 60}, {90, 60}}, {}}, ObstacleKind::kObstacle, "pond"}};
  PlanSettings settings;
  settings.turns = TurnPlanning::kTurns;
  settings.avoid = Avoidance::kCut;
  const Plan bare = plan_field(field, {"", 3, 6}, {}, settings);
  EXPECT_GT(bare.tally.stops, 0);
  settings.obstacle_headlands = 3;
  const Plan with_headland = plan_field(field, {"", 3, 6}, {}, settings);
  EXPECT_EQ(with_headland.tally.stops, 0);
  const check::Verdict verdict = check::verify(with_headland);
  EXPECT_TRUE(verdict.holds()) << verdict.violations.front().what;
}

// The land is cut 6 m before a wall right across it. Tracks end at the cut, nothing touches the wall, and yet
// there is no room to turn.
TEST(Stops, ASeamJustBeforeAnObstacleAbolishesNone) {
  Field field = rectangle(200, 60);
  field.obstacles = {{{{{100, 0}, {110, 0}, {110, 60}, {100, 60}}, {}}, ObstacleKind::kObstacle, "wall"}};
  PlanSettings settings;
  settings.turns = TurnPlanning::kTurns;
  settings.boundary = EdgeKind::kHard;
  settings.given.subfields = {{{{{{0, 0}, {94, 0}, {94, 60}, {0, 60}}, {}}},
                               "west",
                               Direction::clockwise_from_north(Angle::degrees(90)),
                               {}}};
  const Plan plan = plan_field(field, {"", 3, 6}, {}, settings);
  int ends_at_seam = 0;
  for (const TrackPiece& piece : plan.pieces)
    for (const auto& [end, stop] :
         {std::pair(piece.start, piece.stop_at_start), std::pair(piece.end, piece.stop_at_end)}) {
      if (std::abs(end.x - 94) > 0.5) continue;
      ++ends_at_seam;
      EXPECT_TRUE(stop) << "at " << end.y;
    }
  EXPECT_GT(ends_at_seam, 10);
  const check::Verdict verdict = check::verify(plan);
  EXPECT_TRUE(verdict.holds()) << verdict.violations.front().what;
}

TEST(SkipPattern, LeavesOutNoTrackAndJumpsFarEnough) {
  for (std::size_t tracks = 0; tracks < 200; ++tracks)
    for (std::size_t jump = 1; jump < 9; ++jump) {
      const std::vector<std::size_t> order = order::skip_pattern(tracks, jump);
      ASSERT_EQ(order.size(), tracks);
      ASSERT_EQ(std::set<std::size_t>(order.begin(), order.end()).size(), tracks);
      if (tracks < 2 * jump + 1) continue;
      for (std::size_t i = 1; i < tracks; ++i)
        ASSERT_GE(order[i] > order[i - 1] ? order[i] - order[i - 1] : order[i - 1] - order[i], jump);
    }
}

class TurnAttack : public ::testing::Test {
 protected:
  static Plan sound() { return plan_field(rectangle(200, 120), {"", 3, 6}, {}, headlands_for_turns(4)); }
  static void expect_found(const std::function<void(Plan&)>& attack, check::Rule rule) {
    Plan plan = sound();
    ASSERT_TRUE(check::verify(plan).holds());
    attack(plan);
    const check::Verdict verdict = check::verify(plan);
    EXPECT_TRUE(std::any_of(verdict.violations.begin(), verdict.violations.end(),
                            [&](const check::Violation& found) { return found.rule == rule; }));
  }
  static SteeredStretch& stretch(Plan& plan, std::size_t i) { return plan.turns.at(3).manoeuvre.path.at(i); }
};

TEST_F(TurnAttack, AStretchMovedIsFound) {
  expect_found([](Plan& plan) { stretch(plan, 0).start.at.x += 0.1; }, check::Rule::kTurns);
}

TEST_F(TurnAttack, ATurnToAnotherTrackIsFound) {
  expect_found([](Plan& plan) { plan.turns[3].manoeuvre.path = plan.turns[4].manoeuvre.path; },
               check::Rule::kTurns);
}

TEST_F(TurnAttack, ATighterArcIsFound) {
  expect_found(
      [](Plan& plan) {
        for (SteeredStretch& one : plan.turns[3].manoeuvre.path) {
          one.curvature_at_start *= 1.2;
          one.curvature_at_end *= 1.2;
        }
      },
      check::Rule::kTurns);
}

TEST_F(TurnAttack, ReversingIsFound) {
  expect_found([](Plan& plan) { stretch(plan, 0).gear = Gear::kReverse; }, check::Rule::kTurns);
}

TEST_F(TurnAttack, AnotherTimeIsFound) {
  expect_found([](Plan& plan) { plan.turns[3].time_s += 1; }, check::Rule::kTurns);
}

// A front of 8 m on a vehicle of 2.5 m sweeps √((6 + 1.25)² + 8²) = 10.8 m about the centre of the arc, which
// lies at the ends of the tracks; three passes are 9 m.
TEST_F(TurnAttack, AnOutlineThatLeavesTheLandIsFound) {
  expect_found(
      [](Plan& plan) {
        plan.machine.turning.front_overhang_m = 8;
        plan.machine.turning.vehicle_width_m = 2.5;
      },
      check::Rule::kTurns);
}

TEST_F(TurnAttack, AStopThatIsNoneIsFound) {
  expect_found([](Plan& plan) { plan.pieces[2].stop_at_end = true; }, check::Rule::kStops);
}

TEST_F(TurnAttack, AStopConcealedIsFound) {
  PlanSettings settings;
  settings.turns = TurnPlanning::kTurns;
  settings.headlands = 1;
  Plan plan = plan_field(rectangle(100, 60), {"", 3, 6}, {}, settings);
  plan.pieces[0].stop_at_start = false;
  const check::Verdict verdict = check::verify(plan);
  EXPECT_TRUE(std::any_of(verdict.violations.begin(), verdict.violations.end(),
                          [](const check::Violation& found) { return found.rule == check::Rule::kStops; }));
}

}  // namespace tramline::turning_test
