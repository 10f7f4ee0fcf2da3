#include "tramline/planner/search/sweep_search.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include "planner/prepared.h"
#include "tramline/planner/plan_field.h"
#include "tramline/planner/search/straight_search.h"

namespace tramline::sweep_search_test {

std::vector<LinedSubfield> driven(const SearchTask& task, double degrees) {
  return {{{task.ground.plannable.front(), Direction::clockwise_from_north(Angle::degrees(degrees))}, 0}};
}

// Sixty that look cheap and are not stand before the one that is cheapest with all tracks cut.
TEST(SweepSearch, NeverCostsMoreThanToCutAllTracks) {
  Field field;
  field.outer = {{0, 0}, {30, 0}, {30, 300}, {0, 300}};
  const testing::Prepared prepared{{field, {}, {}, {}}};
  const SearchTask task = prepared.task();
  std::vector<SweptCandidate> swept;
  for (int i = 0; i < 60; ++i) swept.push_back({driven(task, 90), {1000, 1000, 0}});
  const double north = outlook_on(task, driven(task, 0)).cut;
  swept.push_back({driven(task, 0), {north, north, 1}});
  const auto found = cheapest_swept(task, swept, kAnyCost, SearchContext(1));
  ASSERT_TRUE(found);
  EXPECT_EQ(found->cost(), north);
  EXPECT_LT(north, outlook_on(task, driven(task, 90)).cut);
}

// A field of 600 sides, all with a direction of their own but for opposite ones.
TEST(SweepSearch, SaysHowManyDirectionsItLeavesOut) {
  Field field;
  for (int i = 0; i < 600; ++i) {
    const double angle = 2 * std::numbers::pi * i / 600;
    field.outer.push_back({100 * std::cos(angle), 100 * std::sin(angle)});
  }
  PlanSettings settings;
  settings.strategy = Strategy::kSweep;
  const Plan plan = plan_field(field, {"", 6, 6, -1}, {}, settings, 1);
  const std::string said = fmt::format(
      "the edges of the field have 300 directions, of which the sweep tries those {} of the longest edges",
      plan.directions_tried);
  EXPECT_EQ(std::count(plan.warnings.begin(), plan.warnings.end(), said), 1) << plan.warnings.front();
  EXPECT_LT(plan.directions_tried, 300);
}

// With a pole in the way the best search looks at the sweep itself, without one it does not: the plan, and
// what it says of its directions, is the same whether the candidates are asked for or not.
TEST(BestSearch, FindsTheSameWithoutTheCandidatesOfTheSweep) {
  for (const bool pole : {false, true}) {
    Field field;
    field.outer = {{0, 0}, {120, 10}, {110, 90}, {60, 70}, {20, 140}};
    if (pole) {
      field.obstacles.emplace_back();
      field.obstacles.back().shape.outer = {{50, 40}, {53, 40}, {53, 43}, {50, 43}};
    }
    const testing::Prepared prepared{{field, {"", 6, 6, -1}, {}, {}}};
    const SearchTask task = prepared.task();
    const SearchContext context = SearchContext(1).without_bound();
    const SearchResult asked = straight_search(task, context),
                       not_asked = straight_search(task, context.without_sweep());
    EXPECT_FALSE(asked.swept.empty());
    EXPECT_EQ(not_asked.swept.empty(), !pole);
    EXPECT_EQ(not_asked.best.cost(), asked.best.cost());
    EXPECT_EQ(not_asked.best.avoided.tally.pieces, asked.best.avoided.tally.pieces);
    EXPECT_EQ(not_asked.directions_tried, asked.directions_tried);
  }
}

/// A comb of 60 teeth, each side with a direction of its own, and a pole.
Field comb_with_a_pole() {
  Field field;
  field.outer = {{0, 0}, {244, 0}};
  for (int i = 60; i > 0; --i) {
    field.outer.push_back({4.0 * i + 2, 100 + 0.3 * i});
    field.outer.push_back({4.0 * i, 90 - 0.2 * i});
  }
  field.outer.push_back({0, 95});
  field.obstacles.push_back(
      {{{{100, 40}, {100, 41}, {101, 41}, {101, 40}}, {}}, ObstacleKind::kObstacle, "pole"});
  return field;
}

// With the rule of the paper all candidates get their detours.
TEST(SweepSearch, LeavesOutNoDetoursOfThePaper) {
  PlanSettings settings;
  settings.strategy = Strategy::kSweep;
  settings.avoid = Avoidance::kPaper;
  const Plan plan = plan_field(comb_with_a_pole(), {"", 3, 6, -1}, {}, settings, 1);
  ASSERT_GT(plan.directions_tried, 48);
  for (const std::string& sentence : plan.warnings)
    EXPECT_EQ(sentence.find("did not look for ways past"), std::string::npos) << sentence;
}

// Candidates beyond those tried count where their outlook is better than the plan.
TEST(SweepSearch, CountsCandidatesWithoutDetours) {
  const testing::Prepared prepared{{comb_with_a_pole(), {}, {}, {}}};
  const SearchTask task = prepared.task();
  std::vector<SweptCandidate> swept;
  for (int i = 0; i < 60; ++i) swept.push_back({driven(task, 90), {1000, 1000, 10.0 + i}});
  EXPECT_EQ(sweep_limits(task, swept, 1000).without_detours, 12);
  EXPECT_EQ(sweep_limits(task, swept, 10 + 58).without_detours, 10) << "68 and 69 are no less";
  EXPECT_EQ(sweep_limits(task, swept, 20).without_detours, 0);
}

}  // namespace tramline::sweep_search_test
