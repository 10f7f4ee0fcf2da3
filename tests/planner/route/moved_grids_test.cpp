// Grids of tracks beside one that is known, and all round the compass.

#include "tramline/planner/whole/moved_grids.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "planner/route/strip.h"
#include "tramline/planner/plans/cheapest_route.h"
#include "tramline/planner/whole/route_floor.h"

namespace tramline {
namespace {

/// 40 m by 200 m towards the north, with two passes of 6 m along its short sides and none along the others,
/// and tracks across it. Time costs nothing.
LaidOut across_the_strip(const Field& field = testing::strip_field()) {
  Machine machine = testing::strip_machine();
  machine.rates.price_per_hour = machine.rates.fuel_l_per_h = 0;
  PlanSettings settings;
  settings.boundary = EdgeKind::kHard;
  const PlanningProblem problem = with_track_prices(planning_problem(field, machine, {}, settings));
  Plan layout;
  layout.machine = machine;
  layout.subfields.push_back({{field.outer, {}}, Direction::clockwise_from_north(Angle::degrees(90))});
  auto trial = headland_trial(problem, layout, {{2, 0, 2, 0}, {}}, Offset::kBest, SearchContext(1));
  return {Alternative::kSearched, trial.value()};
}

/// Areas of a plan are rounded on other roads than those by which its tracks are compared, EUR.
constexpr double kRounding = 1e-6;

double floor_of(const LaidOut& laid) {
  return route_floor(laid.trial.draft.plan, *laid.trial.prepared.turning_land);
}

/// The same land with all tracks on one grid.
LaidOut on_grid(LaidOut laid, double deg, double origin_m) {
  HeadlandTrial& trial = laid.trial;
  trial.problem.settings.turns = TurnPlanning::kNone;
  const SearchTask task(trial.problem, trial.prepared);
  std::vector<LinedSubfield> lines;
  for (const Polygon& part : trial.prepared.ground.plannable)
    lines.push_back({{part, Direction::clockwise_from_north(Angle::degrees(deg))}, origin_m});
  trial.found = {};
  trial.found.best = candidate_on(task, lines);
  trial.draft = drafted(task, trial.found);
  return laid;
}

double degrees_of(const LaidOut& laid) { return laid.trial.draft.plan.subfields.front().direction.degrees(); }

Point first_start(const LaidOut& laid) { return laid.trial.draft.plan.pieces.front().start; }

// Across 31 tracks leave next to nothing of 176 m, and every one of them ends blindly at both of its ends.
// Along the strip at most seven miss or overlap some of 40 m, and end in front of 12 m of headland.
TEST(AllRoundTheCompass, KnowsEndsWithoutAWayOff) {
  const LaidOut across = across_the_strip();
  const std::vector<LaidOut> all = all_round_the_compass(across, 4, kAnyCost, SearchContext(1));
  ASSERT_EQ(all.size(), 4U);
  EXPECT_LT(all.front().trial.found.best.avoided.tally.pieces, 8);
  EXPECT_DOUBLE_EQ(degrees_of(all.front()), 0);
  EXPECT_LT(floor_of(all.front()), floor_of(across));
}

TEST(AllRoundTheCompass, BeginsWithTheLowestFloorsForAnyNumberOfThreads) {
  const LaidOut across = across_the_strip();
  const std::vector<LaidOut> all = all_round_the_compass(across, 12, kAnyCost, SearchContext(1));
  const std::vector<LaidOut> again = all_round_the_compass(across, 12, kAnyCost, SearchContext(3));
  ASSERT_EQ(all.size(), 12U);
  ASSERT_EQ(again.size(), all.size());
  for (std::size_t i = 0; i < all.size(); ++i) {
    EXPECT_NEAR(std::remainder(degrees_of(all[i]), 3), 0, 1e-9) << i;
    if (i > 0) {
      EXPECT_GE(floor_of(all[i]), floor_of(all[i - 1]) - kRounding) << i;
    }
    EXPECT_EQ(degrees_of(again[i]), degrees_of(all[i])) << i;
    EXPECT_EQ(floor_of(again[i]), floor_of(all[i])) << i;
  }
  // Of all others, drafted as plans, none has a lower floor.
  for (double deg = 0; deg < 180; deg += 15)
    for (int eighths = 0; eighths < 8; ++eighths) {
      const LaidOut other = on_grid(across, deg, eighths * 6.0 / 8);
      const bool returned = std::ranges::any_of(all, [&](const LaidOut& one) {
        return degrees_of(one) == degrees_of(other) && std::abs(floor_of(one) - floor_of(other)) < kRounding;
      });
      if (!returned) {
        EXPECT_GE(floor_of(other), floor_of(all.back()) - kRounding) << deg << "° " << eighths;
      }
    }
}

// What lies above a floor is left out, as far as the stops need not be known.
TEST(AllRoundTheCompass, LeavesOutWhatCostsMore) {
  const LaidOut across = across_the_strip();
  const std::vector<LaidOut> all = all_round_the_compass(across, 12, kAnyCost, SearchContext(1));
  const double third = floor_of(all[2]);
  const std::vector<LaidOut> up_to = all_round_the_compass(across, 12, third + kRounding, SearchContext(1));
  ASSERT_GE(up_to.size(), 3U);
  for (std::size_t i = 0; i < 3; ++i) EXPECT_EQ(floor_of(up_to[i]), floor_of(all[i])) << i;
  for (const LaidOut& laid : up_to)
    EXPECT_LE(floor_without_stops(laid.trial.draft.plan, laid.trial.draft.plan.headland.passes),
              third + 2 * kRounding);
  EXPECT_TRUE(all_round_the_compass(across, 12, -1, SearchContext(1)).empty());
}

// A pond of 8 m that tracks cut or go round: of all directions and grids, each with its ways round, none has
// a lower floor than the first.
TEST(AllRoundTheCompass, FindsTheLowestFloorAmongObstacles) {
  Field field = testing::strip_field();
  field.obstacles.push_back({{{{16, 90}, {24, 90}, {24, 98}, {16, 98}}, {}}, ObstacleKind::kObstacle, ""});
  const LaidOut across = across_the_strip(field);
  const std::vector<LaidOut> all = all_round_the_compass(across, 4, kAnyCost, SearchContext(1));
  ASSERT_EQ(all.size(), 4U);
  double least = std::numeric_limits<double>::infinity();
  for (double deg = 0; deg < 180; deg += 3)
    for (int eighths = 0; eighths < 8; ++eighths)
      least = std::min(least, floor_of(on_grid(across, deg, eighths * 6.0 / 8)));
  EXPECT_NEAR(floor_of(all.front()), least, kRounding);
}

TEST(Beside, TurnsAndMovesALittle) {
  const LaidOut across = across_the_strip();
  const std::vector<LaidOut> near = beside(across, 5, SearchContext(1));
  ASSERT_EQ(near.size(), 5U);
  for (std::size_t i = 0; i < near.size(); ++i) {
    EXPECT_LE(std::abs(degrees_of(near[i]) - 90), 3 + 1e-9) << i;
    if (i > 0) {
      EXPECT_GE(floor_of(near[i]), floor_of(near[i - 1]) - 1e-9) << i;
    }
    // None is where the tracks were, or where another is.
    for (std::size_t k = 0; k < i; ++k)
      EXPECT_NE(first_start(near[i]), first_start(near[k])) << i << " " << k;
    EXPECT_NE(first_start(near[i]), first_start(across)) << i;
  }
}

}  // namespace
}  // namespace tramline
