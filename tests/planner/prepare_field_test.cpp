#include "tramline/planner/prepare_field.h"

#include <gtest/gtest.h>

#include <utility>
#include <vector>

#include "support/box_ring.h"
#include "tramline/geometry/error.h"
#include "tramline/planner/candidate/search_task.h"
#include "tramline/planner/plan_field.h"
#include "tramline/planner/search/straight_search.h"

namespace tramline::prepare_field_test {

using testing_support::box;

/// 300 × 200 m with a square in it, `size_m` wide.
Field field_with_square(double size_m) {
  Field field;
  field.id = "square";
  field.outer = box(0, 0, 300, 200);
  field.obstacles = {
      {{box(150, 101.5, 150 + size_m, 101.5 + size_m), {}}, ObstacleKind::kObstacle, "square"}};
  return field;
}

PlanSettings with_headlands(int field, int obstacles) {
  PlanSettings settings;
  settings.headlands = field;
  settings.obstacle_headlands = obstacles;
  return settings;
}

const Machine kMachine{"", 6, 6, -1};

TEST(PlanningProblem, HasAHardBoundaryWhereThereAreHeadlands) {
  const Field field = field_with_square(1);
  EXPECT_EQ(planning_problem(field, kMachine, {}, {}).settings.boundary, EdgeKind::kSoft);
  EXPECT_EQ(planning_problem(field, kMachine, {}, with_headlands(1, 0)).settings.boundary, EdgeKind::kHard);
  EXPECT_THROW(planning_problem(field, {"", -1, 6, -1}, {}, {}), Error);
  EXPECT_THROW(planning_problem(field, {"", 1e-3, 6, -1}, {}, {}), Error);
}

// A pole of 1 m is gone round, and has no headland: what the search has found that told so is the plan.
TEST(PrepareField, HandsOnTheSearchOfTheVeryField) {
  const PlanningProblem problem = planning_problem(field_with_square(1), kMachine, {}, with_headlands(1, 1));
  ASSERT_FALSE(settings_decide_headlands(problem));
  std::vector<std::pair<int, int>> told;
  const Progress progress = [&told](int done, int total) {
    told.emplace_back(done, total);
    return Demand::kGoOn;
  };
  const std::optional<Preparation> prepared = prepare_field(problem, SearchContext(1, progress));
  ASSERT_TRUE(prepared);
  ASSERT_TRUE(prepared->found);
  EXPECT_FALSE(told.empty());
  for (const auto& [done, total] : told) EXPECT_EQ(done, 0) << "of " << total;

  const SearchResult again = straight_search(SearchTask(problem, prepared->field), SearchContext(1));
  EXPECT_EQ(prepared->found->best.cost(), again.best.cost());
  EXPECT_EQ(prepared->found->proof.bound, again.proof.bound);
  EXPECT_EQ(prepared->found->directions_tried, again.directions_tried);

  told.clear();
  const Plan plan = plan_field(problem.field, kMachine, {}, problem.settings, 1, progress);
  EXPECT_EQ(plan.track_tally.pieces, again.best.avoided.tally.pieces);
  ASSERT_FALSE(told.empty());
  EXPECT_GT(told.back().second, 0);
  EXPECT_EQ(told.back().first, told.back().second) << "counted in the end";
}

// Nobody drives round a square of 60 m with a detour: it has passes, and the field is another one.
TEST(PrepareField, SearchesAgainBehindAHeadlandRoundAnObstacle) {
  const PlanningProblem problem = planning_problem(field_with_square(60), kMachine, {}, with_headlands(1, 1));
  const std::optional<Preparation> prepared = prepare_field(problem, SearchContext(1));
  ASSERT_TRUE(prepared);
  EXPECT_FALSE(prepared->found);
  EXPECT_NEAR(prepared->field.body_m2, 288 * 188 - 72 * 72, 40) << "corners are round";
}

TEST(PrepareField, LeavesItToTheSettingsWhereNoTrackGoesRound) {
  PlanningProblem problem = planning_problem(field_with_square(1), kMachine, {}, with_headlands(1, 1));
  problem.settings.avoid = Avoidance::kCut;
  EXPECT_TRUE(settings_decide_headlands(problem));
  EXPECT_FALSE(prepare_field(problem, SearchContext(1)).value().found);
}

TEST(PrepareField, GivesNothingWhereNoPassHasRoom) {
  Field narrow;
  narrow.outer = box(0, 0, 100, 5);
  EXPECT_FALSE(prepare_field(planning_problem(narrow, kMachine, {}, with_headlands(1, 0)), SearchContext(1)));
}

// Behind a headland the boundary is out of reach of all swaths, straight and curved.
TEST(PrepareField, HasAHardFieldWhereSwathsEndAtIt) {
  const Field field = field_with_square(1);
  PlanSettings hard;
  hard.boundary = EdgeKind::kHard;
  const auto hard_field = [&](const PlanSettings& settings) {
    return prepare_field(planning_problem(field, kMachine, {}, settings), SearchContext(1))
        .value()
        .field.hard_field;
  };
  EXPECT_TRUE(hard_field({}).empty());
  EXPECT_EQ(hard_field(hard), (Region{{field.outer, {}}}));
  EXPECT_TRUE(hard_field(with_headlands(1, 0)).empty());
  hard.obstacle_headlands = 1;
  EXPECT_FALSE(hard_field(hard).empty());
}

TEST(PrepareField, TellsWhereTheClearanceTakesAll) {
  PlanSettings settings;
  for (const double clearance_m : {0.0, 1.0, 400.0}) {
    settings.clearance_m = clearance_m;
    const PlanningProblem problem = planning_problem(field_with_square(1), kMachine, {}, settings);
    EXPECT_EQ(field_without_headlands(problem).clearance_takes_all, clearance_m == 400);
  }
}

}  // namespace tramline::prepare_field_test
