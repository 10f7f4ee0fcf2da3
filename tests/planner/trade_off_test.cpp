#include "tramline/planner/pareto/trade_off.h"
#include "support/refusals.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tramline/geometry/error.h"
#include "tramline/planner/pareto/dominance.h"
#include "tramline/planner/pareto/front_marks.h"
#include "tramline/planner/plan_field.h"

namespace tramline {
namespace {

/// A slanting side, so that ends cost something, and a pond.
Field field() {
  Field out;
  out.id = "slant";
  out.outer = {{0, 0}, {160, 0}, {120, 70}, {0, 60}};
  out.obstacles = {{{{{60, 25}, {70, 25}, {70, 34}, {60, 34}}, {}}, ObstacleKind::kObstacle, "pond"}};
  return out;
}

Machine six_metres() { return {"", 6, 6, -1}; }

TEST(PricesToSearch, AreSixteenAtMostAndNoTwoAlike) {
  EXPECT_EQ(prices_to_search({}).size(), 16u);
  // A price of 0 stays 0 times anything.
  EXPECT_EQ(prices_to_search({0, 1, 1, 0, 0}).size(), 12u);
  EXPECT_EQ(prices_to_search({1, 1, 99999, 0, 0}).size(), 15u);
}

TEST(TradeOff, PlansAreLaidAgainAsTheyWereTallied) {
  const TradeOff found = trade_off(field(), six_metres(), {}, {}, 1);
  ASSERT_GT(found.front.points.size(), 3u);
  for (std::size_t i = 0; i < found.front.points.size(); ++i) {
    SCOPED_TRACE(i);
    const Tally& listed = found.front.points[i].tally;
    const Plan plan = plan_of(found, i);
    EXPECT_EQ(plan.tally.overlap_m2, listed.overlap_m2);
    EXPECT_EQ(plan.tally.uncovered_m2, listed.uncovered_m2);
    EXPECT_EQ(plan.tally.turns, listed.turns);
    EXPECT_EQ(plan.tally.stops, listed.stops);
    EXPECT_EQ(plan.subfields.size(), found.front.points[i].directions.size());
    EXPECT_EQ(plan.objective.overlap, found.front.points[i].laid_for.overlap);
  }
}

TEST(TradeOff, KnowsThePlanOfTheGivenPrices) {
  const TradeOff found = trade_off(field(), six_metres(), {}, {}, 1);
  const Plan planned = plan_field(field(), six_metres(), {}, {}, 1);
  const Plan given = given_plan(found);
  EXPECT_EQ(given.cost, planned.cost);
  EXPECT_EQ(given.pieces.size(), planned.pieces.size());
  const FrontPoint& winner = found.front.points[found.front.marks.given_prices];
  EXPECT_LE(winner.cost, planned.cost + 1e-3);
  for (const FrontPoint& point : found.front.points) EXPECT_FALSE(dominates(planned.tally, point.tally));
}

/// Twelve fields that swaths of 12 m fit without overlap in one direction at least: rectangles a whole number
/// of widths across, turned by various angles, so that corners lie off the grid of booleans.
TEST(TradeOff, NoAreaIsLessThanNothing) {
  Machine machine;
  machine.width_m = 12;
  for (int turn = 0; turn < 12; ++turn) {
    SCOPED_TRACE(turn);
    const double angle = 0.13 * turn, c = std::cos(angle), s = std::sin(angle);
    Field out;
    out.id = "turned";
    for (const Point p : {Point{0, 0}, Point{144.7, 0}, Point{144.7, 72}, Point{0, 72}})
      out.outer.push_back({c * p.x - s * p.y, s * p.x + c * p.y});
    for (const FrontPoint& point : trade_off(out, machine, {}, {}, 1).front.points)
      for (const double area_m2 : {point.tally.overlap_m2, point.tally.uncovered_m2}) {
        EXPECT_GE(area_m2, 0);
        EXPECT_FALSE(std::signbit(area_m2));
      }
  }
}

TEST(TradeOff, IsTheSameForAnyNumberOfThreads) {
  const TradeOff one = trade_off(field(), six_metres(), {}, {}, 1),
                 three = trade_off(field(), six_metres(), {}, {}, 3);
  ASSERT_EQ(one.front.points.size(), three.front.points.size());
  for (std::size_t i = 0; i < one.front.points.size(); ++i) {
    EXPECT_EQ(one.front.points[i].tally.overlap_m2, three.front.points[i].tally.overlap_m2);
    EXPECT_EQ(one.front.points[i].tally.uncovered_m2, three.front.points[i].tally.uncovered_m2);
    EXPECT_EQ(one.front.points[i].directions, three.front.points[i].directions);
  }
  EXPECT_EQ(one.front.marks.knee, three.front.marks.knee);
}

TEST(TradeOff, TellsOfSearchesAsTheyEnd) {
  int last = 0;
  trade_off(field(), six_metres(), {}, {}, 2, [&](int done, int total) {
    // Between two searches the same is told again and again, and before the first nothing.
    if (done == last) return Demand::kGoOn;
    EXPECT_EQ(done, ++last);
    EXPECT_EQ(total, 16);
    return Demand::kGoOn;
  });
  EXPECT_EQ(last, 16);
}

TEST(TradeOff, RefusesWhatPlanFieldRefuses) {
  EXPECT_REFUSED(trade_off(field(), {"", 200, 6, -1}, {}, {}));
  EXPECT_REFUSED(trade_off(field(), {"", -1, 6, -1}, {}, {}));
}

}  // namespace
}  // namespace tramline
