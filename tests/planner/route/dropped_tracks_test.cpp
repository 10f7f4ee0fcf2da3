// Tracks that cost more to drive to than their land is worth, and plans without them.

#include "tramline/planner/whole/dropped_tracks.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "tramline/check/verify.h"
#include "tramline/planner/plan_field.h"

namespace tramline {
namespace {

/// A field of 100 by 60 m, which has a bay 7 m wide and 21 m deep at its northern side.
PlanningProblem with_bay(double price_per_stop) {
  Field field;
  field.id = "bay";
  field.outer = {{0, 0}, {100, 0}, {100, 60}, {57, 60}, {57, 81}, {50, 81}, {50, 60}, {0, 60}};
  Machine machine;
  machine.width_m = 3;
  machine.radius_m = 2;
  machine.rates.price_per_stop = price_per_stop;
  PlanSettings settings;
  settings.turns = TurnPlanning::kRoute;
  settings.aim = Aim::kWholeCost;
  settings.boundary = EdgeKind::kHard;
  return planning_problem(field, machine, {}, settings);
}

Plan from_east_to_west(const PlanningProblem& problem) {
  Plan out;
  out.machine = problem.machine;
  out.subfields.push_back({{problem.field.outer, {}}, Direction::clockwise_from_north(Angle::degrees(90))});
  return out;
}

/// With two passes at the ends of the tracks over the field, and none in the bay.
HeadlandTrial trial_of(const PlanningProblem& problem) {
  const PassesByBoundary passes{{0, 2, 0, 0, 0, 0, 0, 2},
                                std::vector<int>(problem.field.obstacles.size(), 0)};
  std::optional<HeadlandTrial> out =
      headland_trial(problem, from_east_to_west(problem), passes, Offset::kBest, SearchContext(1));
  if (!out) throw std::logic_error("no track fits");
  return std::move(*out);
}

bool in_the_bay(const TrackPiece& piece) { return piece.start.y > 60; }

// Seven tracks in the bay are 7 m long: 21 m², which are worth 1.47 EUR at a margin of 700 EUR/ha. A stop
// costs 5 EUR. The tracks across the field, 88 m long, are worth 18 EUR each, and one turns at their ends.
TEST(NotWorthTheirWays, AreTracksInABayThatOneBacksOutOf) {
  const HeadlandTrial trial = trial_of(with_bay(5));
  const std::vector<TrackPiece>& pieces = trial.draft.plan.pieces;
  ASSERT_EQ(std::ranges::count_if(pieces, in_the_bay), 7);
  const std::vector<PieceRun> runs = not_worth_their_ways(trial);
  ASSERT_FALSE(runs.empty());
  std::size_t found = 0;
  for (const PieceRun& run : runs) {
    EXPECT_GT(run.saved, 1.4 * static_cast<double>(run.count)) << "as much again as the land is worth";
    for (std::size_t i = run.first; i < run.first + run.count; ++i, ++found)
      EXPECT_TRUE(in_the_bay(pieces[i])) << i;
  }
  EXPECT_GE(found, 6U);
  EXPECT_TRUE(std::ranges::is_sorted(runs, std::greater<>(), &PieceRun::saved));
}

// Where neither time nor stops cost anything, only land without room to get there is left.
TEST(NotWorthTheirWays, AreNoneWhereWaysCostNothing) {
  PlanningProblem problem = with_bay(0);
  problem.machine.rates.price_per_hour = problem.machine.rates.fuel_l_per_h = 0;
  const HeadlandTrial trial = trial_of(problem);
  EXPECT_EQ(legs_without_room(trial.draft.plan.route, trial.draft.plan.machine), 0U);
  EXPECT_TRUE(not_worth_their_ways(trial).empty());
}

TEST(Without, LeavesTheLandOfTheTracksUncovered) {
  const HeadlandTrial whole = trial_of(with_bay(5));
  const PieceRun run = not_worth_their_ways(whole).front();
  const HeadlandTrial less = without({run}, whole);
  const PlanDraft draft = drafted(SearchTask(less.problem, less.prepared), less.found);
  const Plan &before = whole.draft.plan, &after = draft.plan;
  EXPECT_EQ(after.pieces.size() + run.count, before.pieces.size());
  EXPECT_EQ(std::ranges::count(after.dropped, DroppedFor::kWay, &DroppedPiece::why),
            static_cast<std::ptrdiff_t>(run.count));
  double worked_m2 = 0, gone_m2 = 0;
  for (const TrackPiece& piece : after.pieces) worked_m2 += 3 * length(piece);
  for (std::size_t i = run.first; i < run.first + run.count; ++i) gone_m2 += 3 * length(before.pieces[i]);
  EXPECT_NEAR(worked_m2, area(after.body) - after.tally.uncovered_m2 + after.tally.overlap_m2, 1e-6);
  EXPECT_NEAR(after.tally.worked_m2, before.tally.worked_m2 - gone_m2, 1e-6);
  EXPECT_GT(after.tally.uncovered_m2, before.tally.uncovered_m2);
  // What was foreseen is about what is saved.
  const double saved = whole_cost(before).euros() - whole_cost(after).euros();
  EXPECT_NEAR(saved, run.saved, 0.25 * run.saved);
}

// A track that goes round a pylon is left out. What was decided at the pylon would not pay without it, and
// the plan says why it is so.
TEST(Without, LeavesNoWayPastAnObstacleThatSeemsCheaper) {
  PlanningProblem problem = with_bay(5);
  problem.field.obstacles.push_back(
      {{{{40, 29}, {41, 29}, {41, 30}, {40, 30}}, {}}, ObstacleKind::kObstacle, "pylon"});
  const HeadlandTrial whole = trial_of(problem);
  const std::vector<TrackPiece>& pieces = whole.draft.plan.pieces;
  const auto round =
      std::ranges::find_if(pieces, [](const TrackPiece& piece) { return !piece.detours.empty(); });
  ASSERT_NE(round, pieces.end());
  const PieceRun run{static_cast<std::size_t>(round - pieces.begin()), 1, 0};
  HeadlandTrial less = without({run}, whole);
  const SearchTask task(less.problem, less.prepared);
  PlanDraft draft = drafted(task, less.found);
  const Plan plan = finished(task, std::move(less.found), std::move(draft), SearchContext(1));
  EXPECT_EQ(std::ranges::count(plan.dropped, DroppedFor::kWay, &DroppedPiece::why), 1);
  const auto says_so = [](const Encounter& encounter) {
    const std::string why = "tracks here are not worth the way to them";
    return encounter.left.why_not == why || encounter.right.why_not == why;
  };
  EXPECT_TRUE(std::ranges::any_of(plan.encounters, says_so));
  for (const check::Violation& fault : check::verify(plan).violations) ADD_FAILURE() << fault.what;
}

// The bay stays unworked where stops cost 5 EUR each, and is worked where they cost nothing; both plans hold.
TEST(PlanField, LeavesOutWhatIsNotWorthTheWay) {
  const auto planned = [](double price_per_stop) {
    PlanningProblem problem = with_bay(price_per_stop);
    problem.settings.headlands = 2;
    problem.settings.headland_edges = {0, 2, 0, 0, 0, 0, 0, 2};
    return plan_field(problem.field, problem.machine, {}, problem.settings, 1);
  };
  const auto left_out = [](const Plan& plan) {
    return std::ranges::count(plan.dropped, DroppedFor::kWay, &DroppedPiece::why);
  };
  const auto speaks_of_it = [](const Plan& plan) {
    return std::ranges::any_of(plan.warnings, [](const std::string& warning) {
      return warning.find("not worth the way") != std::string::npos;
    });
  };
  const Plan dear = planned(5), free = planned(0);
  EXPECT_GT(left_out(dear), 0);
  EXPECT_EQ(left_out(free), 0);
  EXPECT_TRUE(speaks_of_it(dear));
  EXPECT_FALSE(speaks_of_it(free));
  for (const Plan* plan : {&dear, &free})
    for (const check::Violation& fault : check::verify(*plan).violations) ADD_FAILURE() << fault.what;
}

}  // namespace
}  // namespace tramline
