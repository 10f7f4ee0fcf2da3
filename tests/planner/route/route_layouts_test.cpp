// The land behind passes, from which plans are laid out for the comparison of routes.

#include "tramline/planner/whole/route_layouts.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "planner/route/strip.h"
#include "properties/draws.h"
#include "properties/seeds.h"
#include "tramline/planner/plans/cheapest_route.h"

namespace tramline {
namespace {

PlanningProblem strip_problem(HeadlandRule rule) {
  PlanSettings settings;
  settings.headland_rule = rule;
  return planning_problem(testing::strip_field(), testing::strip_machine(), {}, settings);
}

std::vector<Plan> one_layout(const PlanningProblem& problem) {
  Plan out;
  out.field = problem.field;
  out.machine = problem.machine;
  out.subfields.push_back({{problem.field.outer, {}}, Direction::clockwise_from_north(Angle::degrees(0))});
  return {out};
}

// Of 40 m three passes of 6 m take 36 and leave a strip that is no track's. There is no room for a fourth.
TEST(RouteLayouts, KnowWhenMorePassesAreTheSame) {
  const PlanningProblem problem = strip_problem(HeadlandRule::kTurns);
  const std::vector<Plan> layouts = one_layout(problem);
  RouteLayouts tried(problem, layouts, SearchContext(1));
  for (const int passes : {1, 2, 3})
    EXPECT_TRUE(tried.leave_other_land(tried.all_round(passes, {}))) << passes;
  EXPECT_FALSE(tried.leave_other_land(tried.all_round(4, {})));
}

/// The strip with so many masts of a metre along its middle line.
PlanningProblem strip_with_masts(std::size_t count) {
  PlanningProblem out = strip_problem(HeadlandRule::kTurns);
  out.settings.obstacle_headland_rule = HeadlandRule::kTurns;
  for (std::size_t i = 0; i < count; ++i) {
    const double y = 20.0 * static_cast<double>(i + 1);
    out.field.obstacles.emplace_back();
    out.field.obstacles.back().shape.outer = {{20, y}, {21, y}, {21, y + 1}, {20, y + 1}};
  }
  return out;
}

std::optional<std::vector<int>> none_round(const PlanningProblem& problem) {
  const std::vector<Plan> layouts = one_layout(problem);
  return RouteLayouts(problem, layouts, SearchContext(1)).none_round_obstacles();
}

TEST(RouteLayouts, LeaveObstaclesWithoutHeadlandsWhereThatMayBeChosen) {
  EXPECT_EQ(none_round(strip_with_masts(2)), std::vector<int>(2, 0));
  EXPECT_FALSE(none_round(strip_with_masts(kFewObstacles + 1)));
  PlanningProblem given = strip_with_masts(2);
  given.settings.obstacle_headland_rule = HeadlandRule::kPasses;
  EXPECT_FALSE(none_round(given));
}

TEST(RouteLayouts, KnowBehindWhichPassesCurvesWereLookedFor) {
  PlanningProblem problem = strip_problem(HeadlandRule::kTurns);
  const std::vector<Plan> layouts = one_layout(problem);
  RouteLayouts tried(problem, layouts, SearchContext(1));
  EXPECT_FALSE(tried.looked_for_curves(tried.all_round(2, {})));
  tried.along_curves(tried.all_round(2, {}));
  EXPECT_TRUE(tried.looked_for_curves(tried.all_round(2, {})));
  EXPECT_FALSE(tried.looked_for_curves(tried.all_round(1, {})));
  problem.settings.headland_rule = HeadlandRule::kPasses;
  EXPECT_TRUE(RouteLayouts(problem, layouts, SearchContext(1)).looked_for_curves(tried.all_round(1, {})));
}

/// A strip of two arms that meet at an angle.
Field elbow(std::mt19937_64& random) {
  const double wide_m = uniform(random, 50, 90), long_m = uniform(random, 60, 140);
  const double turned_rad = uniform(random, 0.2, 0.9);
  const Point along{std::cos(turned_rad), std::sin(turned_rad)}, across{-along.y, along.x};
  Field out;
  out.id = "elbow";
  out.outer = {{-long_m, 0},
               {0, 0},
               long_m * along,
               long_m * along + wide_m * across,
               {-0.2 * wide_m, wide_m},
               {-long_m, 0.8 * wide_m}};
  return out;
}

// Subfields of a division are priced by themselves. Laid out anew they know of one another.
TEST(RouteLayouts, LayCurvesOutAsWellAsTheyKnow) {
  int curved = 0;
  testing::for_each_seed(20, [&](std::mt19937_64& random, int) {
    Machine machine = testing::strip_machine();
    machine.width_m = 18;
    PlanSettings settings;
    settings.boundary = EdgeKind::kHard;
    settings.shape = TrackShape::kAuto;
    settings.headland_rule = HeadlandRule::kTurns;
    const PlanningProblem problem = with_track_prices(planning_problem(elbow(random), machine, {}, settings));
    const std::vector<Plan> layouts = one_layout(problem);
    RouteLayouts tried(problem, layouts, SearchContext(1));
    const PassesByBoundary none = tried.all_round(0, {});
    for (const LaidOut& laid : tried.along_curves(none)) {
      const Plan& plan = laid.trial.draft.plan;
      const auto anew = tried.laid_out(Alternative::kSearched, plan, none);
      ASSERT_TRUE(anew);
      EXPECT_LE(plan.cost, anew->trial.draft.plan.cost + 1e-9) << plan.subfields.size();
      ++curved;
    }
  });
  EXPECT_GT(curved, 0);
}

// One pass leaves 28 of 40 m to tracks, two leave 16.
TEST(RouteLayouts, TellLandThatPassesWorkFromLandOfTracks) {
  const PlanningProblem problem = strip_problem(HeadlandRule::kTurns);
  const std::vector<Plan> layouts = one_layout(problem);
  RouteLayouts tried(problem, layouts, SearchContext(1));
  const auto behind = [&](int passes) {
    return tried.laid_out(Alternative::kSearched, layouts.front(), tried.all_round(passes, {}));
  };
  const auto one = behind(1), two = behind(2);
  ASSERT_TRUE(one && two);
  EXPECT_FALSE(passes_work_most(one->trial.prepared));
  EXPECT_TRUE(passes_work_most(two->trial.prepared));
}

// The tracks run along the strip and end at its short sides, where half a circle and half the width are 9 m:
// two passes. Along the long sides only the turns of the outermost tracks may need one.
TEST(RouteLayouts, PutOpenPassesWhereTracksEnd) {
  const PlanningProblem problem = strip_problem(HeadlandRule::kTurns);
  const std::vector<Plan> layouts = one_layout(problem);
  const std::vector<LaidOut> open = RouteLayouts(problem, layouts, SearchContext(1)).behind_open_passes();
  ASSERT_EQ(open.size(), 1U) << "along the longest side, along the length and the layout are one direction";
  const std::vector<int>& edges = open.front().trial.passes.edges;
  ASSERT_EQ(edges.size(), 4U);
  for (const std::size_t side : {0U, 2U}) EXPECT_GE(edges[side], 2) << side;
  for (const std::size_t side : {1U, 3U}) EXPECT_LE(edges[side], 1) << side;
}

// One pass leaves 28 by 188 m. Along it five tracks reach 2 m too far or four leave 4 m, on 188 m; across it
// 31 leave 2 m on 28 m. Where time costs nothing, neither do turns, and tracks go across; by the usual prices
// of tracks 31 of them cost more in turns than the land along the other four.
TEST(RouteLayouts, LayTracksByTheUsualPricesToo) {
  PlanningProblem problem = strip_problem(HeadlandRule::kTurns);
  problem.machine.rates.price_per_hour = problem.machine.rates.fuel_l_per_h = 0;
  problem = with_track_prices(std::move(problem));
  const std::vector<Plan> layouts = one_layout(problem);
  RouteLayouts tried(problem, layouts, SearchContext(1));
  const PassesByBoundary passes = tried.all_round(1, {});
  const std::vector<LaidOut> searched = tried.searched(passes);
  const std::optional<Plan> usual = tried.best_by_usual_prices(passes);
  ASSERT_TRUE(!searched.empty() && usual);
  const auto along_deg = [](const Plan& plan) {
    return angle_between(plan.subfields.front().direction, Direction::clockwise_from_north(Angle::degrees(0)))
        .degrees();
  };
  EXPECT_NEAR(along_deg(searched.back().trial.draft.plan), 90, 1);
  EXPECT_NEAR(along_deg(*usual), 0, 1);
}

/// A strip 60 m wide along a bend of 90° with a radius of 100 m on its inside, with straight ends.
PlanningProblem bent_problem(TrackShape shape) {
  Field field;
  field.id = "bend";
  const auto on_arc = [](double radius_m, int i) {
    const double angle = i * std::numbers::pi / 60;
    return Point{radius_m * std::cos(angle), radius_m * std::sin(angle)};
  };
  for (int i = 0; i <= 30; ++i) field.outer.push_back(on_arc(160, i));
  for (int i = 30; i >= 0; --i) field.outer.push_back(on_arc(100, i));
  Machine machine;
  machine.width_m = 6;
  machine.radius_m = 6;
  PlanSettings settings;
  settings.headland_rule = HeadlandRule::kTurns;
  settings.shape = shape;
  return with_track_prices(planning_problem(field, machine, {}, settings));
}

// Two passes of 6 m leave 36 m of the bend: six tracks along it, where straight ones are chords of it.
TEST(RouteLayouts, LayTracksAlongCurvesOfTheLandBehindPasses) {
  const PlanningProblem problem = bent_problem(TrackShape::kAuto);
  const std::vector<Plan> layouts = one_layout(problem);
  RouteLayouts tried(problem, layouts, SearchContext(1));
  const PassesByBoundary passes = tried.all_round(2, {});
  const std::vector<LaidOut> curved = tried.along_curves(passes);
  ASSERT_FALSE(curved.empty());
  const Plan& plan = curved.front().trial.draft.plan;
  ASSERT_EQ(plan.subfields.size(), 1U);
  EXPECT_FALSE(plan.subfields.front().reference.empty());
  EXPECT_EQ(plan.pieces.size(), 6U);
  EXPECT_LT(plan.cost, tried.searched(passes).back().trial.draft.plan.cost);
}

TEST(RouteLayouts, LayTracksAlongNoCurveOfStraightLandNorWhereTheyAreToBeStraight) {
  const PlanningProblem strip = strip_problem(HeadlandRule::kTurns),
                        straight = bent_problem(TrackShape::kStraight);
  for (PlanningProblem problem : {strip, straight}) {
    if (problem.field.id == "strip") problem.settings.shape = TrackShape::kAuto;
    const std::vector<Plan> layouts = one_layout(problem);
    RouteLayouts tried(problem, layouts, SearchContext(1));
    EXPECT_TRUE(tried.along_curves(tried.all_round(1, {})).empty()) << problem.field.id;
  }
}

TEST(RouteLayouts, PutNoOpenPassesWhereTheyAreGiven) {
  const PlanningProblem problem = strip_problem(HeadlandRule::kPasses);
  const std::vector<Plan> layouts = one_layout(problem);
  EXPECT_TRUE(RouteLayouts(problem, layouts, SearchContext(1)).behind_open_passes().empty());
}

}  // namespace
}  // namespace tramline
