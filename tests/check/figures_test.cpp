// Figures beside a plan that follow from nothing drawn: its bounds, its front, its warnings. One is made
// false at a time; a violation has to name it.

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <limits>
#include <string>

#include "check/plans.h"
#include "tramline/check/file/compare_warnings.h"
#include "tramline/geometry/path/steered_path.h"

namespace tramline {
namespace {

using namespace testing_plans;

struct PlantedChange {
  const char* words;  ///< in what is to be reported
  std::function<void(Plan&)> plant;
};

bool reports(const std::vector<check::Violation>& violations, const std::string& rule,
             const std::string& words) {
  return std::any_of(violations.begin(), violations.end(), [&](const check::Violation& violation) {
    return name(violation.rule) == rule && violation.what.find(words) != std::string::npos;
  });
}

void expect_found(const Plan& honest, const std::string& rule, const std::vector<PlantedChange>& changes) {
  expect_holds(honest);
  for (const PlantedChange& change : changes) {
    Plan plan = honest;
    change.plant(plan);
    EXPECT_TRUE(reports(check::verify(plan).violations, rule, change.words)) << change.words;
  }
}

constexpr double kNoNumber = std::numeric_limits<double>::quiet_NaN();

/// Nine turns of 1 €; nothing says that it can be done for less than 5 €.
Plan plan_with_bounds() {
  Plan plan = rectangle_plan();
  plan.proof.bound = 5;
  plan.proof.one_direction_cost = plan.cost;
  plan.proof.one_direction_bound = 6;
  return plan;
}

TEST(Bounds, ThatCannotBeTrueAreFound) {
  expect_found(
      plan_with_bounds(), "proof",
      {{"bound is 9.010000, above the cost of 9", [](Plan& p) { p.proof.bound = 9.01; }},
       {"bound is -1", [](Plan& p) { p.proof.bound = -1; }},
       {"bound is nan", [](Plan& p) { p.proof.bound = kNoNumber; }},
       {"bound is 5.000000, above the cost of the best plan found with one direction",
        [](Plan& p) { p.proof.one_direction_cost = p.proof.one_direction_bound = 4; }},
       {"bound for one direction is 9.500000, above", [](Plan& p) { p.proof.one_direction_bound = 9.5; }},
       {"bound for one direction is -0.5", [](Plan& p) { p.proof.one_direction_bound = -0.5; }},
       {"price of overlap", [](Plan& p) { p.objective.overlap = -0.02; }},
       {"price of uncovered land", [](Plan& p) { p.objective.uncovered = kNoNumber; }},
       {"price of a turn", [](Plan& p) { p.objective.turn = -1; }},
       {"price of a stop", [](Plan& p) { p.objective.stop = std::numeric_limits<double>::infinity(); }},
       {"price of a subfield", [](Plan& p) { p.objective.subfield = -5; }}});
}

TEST(Bounds, MayBeReached) {
  Plan plan = plan_with_bounds();
  plan.proof.bound = plan.proof.one_direction_bound = plan.cost;
  expect_holds(plan);
}

/// Swaths of 3 m on 3000 m²: the plan itself, and one of a track less that works 30 m² twice.
Plan plan_with_front() {
  Plan plan = rectangle_plan();
  FrontPoint own, other;
  own.tally = other.tally = plan.tally;
  other.tally.overlap_m2 = 30;
  other.tally.worked_m2 = 3030;
  other.tally.track_length_m = 1010;
  other.tally.pieces = 9;
  other.tally.turns = 8;
  for (FrontPoint* point : {&own, &other}) {
    point->directions = {plan.subfields.front().direction};
    point->laid_for = plan.objective;
    point->cost = cost(plan.objective, point->tally);
  }
  plan.front = {plan.objective, {own, other}, {0, 0, 1, 0, 1}};
  return plan;
}

TEST(Fronts, WithAFalseFigureAreFound) {
  const auto second = [](auto change) { return [change](Plan& p) { change(p.front.points[1]); }; };
  expect_found(
      plan_with_front(), "front",
      {{"plan 2 of the front is said to cost 8.500000", second([](FrontPoint& p) { p.cost = 8.5; })},
       {"plan 2 of the front has 9 tracks", second([](FrontPoint& p) { p.tally.turns = 7; })},
       {"plan 2 of the front has a negative figure", second([](FrontPoint& p) { p.tally.stops = -1; })},
       {"plan 2 of the front works", second([](FrontPoint& p) { p.tally.overlap_m2 = 20; })},
       {"plan 2 of the front works", second([](FrontPoint& p) { p.tally.track_length_m = 1000; })},
       {"plan 2 of the front works more subfields", second([](FrontPoint& p) { p.tally.subfields = 2; })}});
}

TEST(Fronts, OutOfOrderOrWithADominatedPlanAreFound) {
  expect_found(plan_with_front(), "front",
               {{"plan 2 of the front is out of order",
                 [](Plan& p) { std::swap(p.front.points[0], p.front.points[1]); }},
                {"plan 2 of the front is no better in anything than plan 1",
                 [](Plan& p) { p.front.points[1] = p.front.points[0]; }}});
}

TEST(Fronts, MarkOnlyPlansThatStandOut) {
  const auto marked = [](std::size_t FrontMarks::*mark, std::size_t index) {
    return [mark, index](Plan& p) { p.front.marks.*mark = index; };
  };
  expect_found(plan_with_front(), "front",
               {{"plan 2 of the front is marked 'least overlap'", marked(&FrontMarks::least_overlap, 1)},
                {"plan 1 of the front is marked 'fewest turns", marked(&FrontMarks::fewest_turns, 0)},
                {"plan 1 of the front is marked 'given prices'", marked(&FrontMarks::given_prices, 0)}});
}

constexpr const char* kUnconnected = "connections between tracks are not planned";

std::vector<check::Violation> judged(Plan plan, std::vector<std::string> warnings) {
  plan.warnings = std::move(warnings);
  return check::compare_warnings(plan);
}

TEST(Warnings, AreDueWhereTheyAreTrue) {
  EXPECT_TRUE(judged(rectangle_plan(), {kUnconnected}).empty());
  EXPECT_TRUE(reports(judged(rectangle_plan(), {}), "warnings", "has no warning 'connections"));
  EXPECT_TRUE(reports(judged(rectangle_plan(), {kUnconnected, "3 % of the land, 90 m², stays unworked"}),
                      "warnings", "'stays unworked' without cause"));
}

/// One of ten tracks left out: 300 of 3000 m².
TEST(Warnings, HaveThePlansFigures) {
  Plan plan = rectangle_plan();
  plan.pieces.erase(plan.pieces.begin() + 4);
  plan = settled(plan);
  EXPECT_TRUE(judged(plan, {kUnconnected, "10.0 % of the land, 300 m², stays unworked"}).empty());
  EXPECT_TRUE(reports(judged(plan, {kUnconnected}), "warnings", "has no warning 'stays unworked'"));
  EXPECT_TRUE(reports(judged(plan, {kUnconnected, "10.0 % of the land, 200 m², stays unworked"}), "warnings",
                      "other figures"));
  EXPECT_TRUE(reports(judged(plan, {kUnconnected, "a tenth of the land stays unworked"}), "warnings",
                      "other figures"));
}

/// 80 of 2960 m² beside the obstacle are missed.
TEST(Warnings, CountPiecesTooShortToTurnFor) {
  Plan plan = obstacle_plan();
  plan.machine.radius_m = 20;  // a piece of 40 m is shorter than 2·20 + 3 m
  const std::string missed = "2.7 % of the land, 80 m², stays unworked";
  const auto counted = [](int count) {
    return std::to_string(count) + " of 12 tracks are shorter than 43.0 m: hardly worth turning for";
  };
  EXPECT_TRUE(judged(plan, {kUnconnected, missed, counted(4)}).empty());
  EXPECT_TRUE(reports(judged(plan, {kUnconnected, missed}), "warnings", "has no warning 'hardly worth"));
  EXPECT_TRUE(reports(judged(plan, {kUnconnected, missed, counted(3)}), "warnings", "other figures"));
}

// Of 130 m of the route the machine backs 10 and 20.
TEST(Warnings, SayHowFarTheMachineBacks) {
  Plan plan = rectangle_plan();
  const auto drive = [&](LegKind kind, double length_m) {
    RouteLeg leg;
    leg.kind = kind;
    leg.path = {arc_from({}, length_m, 0, Gear::kForward)};
    plan.route.legs.push_back(std::move(leg));
  };
  drive(LegKind::kBackOut, 10);
  drive(LegKind::kBackOut, 20);
  drive(LegKind::kTransit, 100);
  EXPECT_TRUE(judged(plan, {"30 m of the route, 23 %, are driven in reverse, up to 20 m at a time"}).empty());
  EXPECT_TRUE(reports(judged(plan, {}), "warnings", "has no warning 'are driven in reverse"));
  EXPECT_TRUE(reports(judged(plan, {"30 m of the route, 23 %, are driven in reverse, up to 30 m at a time"}),
                      "warnings", "other figures"));
  drive(LegKind::kTransit, 300);  // 30 of 430 m are not worth saying
  EXPECT_TRUE(judged(plan, {}).empty());
}

// No pass was driven where there was room for none: a user who asked for two has to be told.
TEST(Warnings, NameThePassesAskedForThatHaveNoRoom) {
  Plan plan = rectangle_plan();
  plan.settings.headlands = 2;
  const std::string lacking = "2 headland passes round the field were asked for, and there is room for 0";
  EXPECT_TRUE(judged(plan, {kUnconnected, lacking}).empty());
  EXPECT_TRUE(reports(judged(plan, {kUnconnected}), "warnings", "has no warning 'headland passes round"));
  plan.settings.headland_rule = HeadlandRule::kTurns;
  EXPECT_TRUE(judged(plan, {kUnconnected}).empty());
  EXPECT_TRUE(reports(judged(plan, {kUnconnected, lacking}), "warnings", "without cause"));
}

TEST(Warnings, RepeatWhatWasSaidOfTheField) {
  Plan plan = rectangle_plan();
  plan.field.warnings = {"a hole was closed"};
  EXPECT_TRUE(judged(plan, {kUnconnected, "a hole was closed"}).empty());
  EXPECT_TRUE(reports(judged(plan, {kUnconnected}), "warnings", "a hole was closed"));
}

}  // namespace
}  // namespace tramline
