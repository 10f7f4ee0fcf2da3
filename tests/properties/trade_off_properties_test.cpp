// What is true of every front, on random fields with obstacles.

#include <gtest/gtest.h>

#include "properties/random_field.h"
#include "tramline/geometry/error.h"
#include "tramline/planner/pareto/dominance.h"
#include "tramline/planner/pareto/front_marks.h"
#include "tramline/planner/pareto/trade_off.h"
#include "tramline/planner/plan_field.h"

namespace tramline::trade_off_properties_test {

using testing::base_seed;
using testing::case_count;
using testing::random_field;

/// What areas below the rounding of criteria_of() may cost.
double slack(const Objective& prices) { return 1e-3 * (prices.overlap + prices.uncovered); }

void expect_front(const Front& front, const Plan& planned, std::mt19937_64& random) {
  for (const FrontPoint& a : front.points) {
    EXPECT_FALSE(dominates(planned.tally, a.tally));
    for (const FrontPoint& b : front.points) EXPECT_FALSE(dominates(a.tally, b.tally));
  }
  EXPECT_LE(front.points[front.marks.given_prices].cost, planned.cost + slack(front.prices));
  // Identity of every tally: Σ w·L = body − u + o.
  const double body_m2 = area(planned.body);
  for (const FrontPoint& point : front.points)
    EXPECT_NEAR(point.tally.worked_m2, body_m2 - point.tally.uncovered_m2 + point.tally.overlap_m2,
                1e-6 * body_m2);
  // No point costs less than the winner, whatever the prices.
  std::uniform_real_distribution<double> price(0, 10);
  const Objective prices{price(random), price(random), price(random), price(random)};
  const double least = cost(prices, front.points[cheapest_for(front, prices)].tally);
  for (const FrontPoint& point : front.points) EXPECT_GE(cost(prices, point.tally), least);
  EXPECT_LE(least, cost(prices, planned.tally) + slack(prices));
}

TEST(TradeOffProperties, NothingIsDominatedAndThePlanIsNoCheaper) {
  int compared = 0;
  const int cases = case_count(3);
  for (int i = 0; i < cases; ++i) {
    const unsigned long long seed = base_seed() + static_cast<unsigned long long>(i);
    SCOPED_TRACE("seed " + std::to_string(seed));
    std::mt19937_64 random(seed);
    const Field field = random_field(random, 2);
    const Machine machine{"", i % 2 == 0 ? 6.0 : 4.5, 6, -1};
    PlanSettings settings;
    settings.strategy = i % 3 == 2 ? Strategy::kSweep : Strategy::kBest;
    try {
      const Plan planned = plan_field(field, machine, {}, settings, 2);
      expect_front(trade_off(field, machine, {}, settings, 2).front, planned, random);
      ++compared;
    } catch (const Error& error) {
      if (error.kind() != ErrorKind::kBadInput) throw;
      // No track fits.
    }
  }
  EXPECT_GT(compared, cases / 2);
}

}  // namespace tramline::trade_off_properties_test
