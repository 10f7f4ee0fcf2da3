// The bound of a route: against all tours, all trees, and closed forms.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <random>
#include <vector>

#include "properties/draws.h"
#include "properties/seeds.h"
#include "route/brute_force.h"
#include "route/scenes.h"
#include "tramline/route/certificate/best_bound.h"
#include "tramline/route/certificate/priced_bound.h"
#include "tramline/route/search/first_tours.h"
#include "tramline/route/search/shortened.h"

namespace tramline::order {
namespace {

using testing::TableCosts;

constexpr double kBoundRounding_s = 1e-7;

std::vector<double> random_prices(const ConnectionBounds& bounds, std::mt19937_64& random) {
  std::vector<double> out(bounds.nodes());
  for (double& price : out) price = uniform(random, -5, 5);
  return out;
}

TableCosts random_case(int number, std::size_t most, std::mt19937_64& random) {
  TableCosts costs =
      testing::random_costs(static_cast<std::size_t>(any_of(random, 1, static_cast<int>(most))), random);
  testing::add_gates(static_cast<std::size_t>(number % 3), costs, random);
  costs.set_least(number % 2 == 0 ? 1 : 0.4);
  return costs;
}

TEST(BoundOf, AnyPricesIsAtMostTheLeastOfAllTours) {
  testing::for_each_seed(60, [](std::mt19937_64& random, int number) {
    const TableCosts costs = random_case(number, 6, random);
    const double least_s = testing::least_of_all_tours(costs);
    for (int i = 0; i < 20; ++i)
      EXPECT_LE(bound_of(random_prices(costs, random), costs), least_s + kBoundRounding_s);
  });
}

TableCosts random_case_with_rings(int number, std::mt19937_64& random) {
  TableCosts costs = testing::random_costs(static_cast<std::size_t>(any_of(random, 0, 3)), random);
  testing::add_gates(static_cast<std::size_t>(number % 3), costs, random);
  testing::add_rings(static_cast<std::size_t>(any_of(random, 1, 3)), costs, random);
  costs.set_least(number % 2 == 0 ? 1 : 0.4);
  return costs;
}

TEST(BoundOf, RingsIsAtMostTheLeastOfAllRoutes) {
  testing::for_each_seed(200, [](std::mt19937_64& random, int number) {
    const TableCosts costs = random_case_with_rings(number, random);
    const double least_s = testing::least_of_all_routes(costs);
    for (int i = 0; i < 20; ++i) {
      const std::vector<double> prices = random_prices(costs, random);
      EXPECT_LE(bound_of(prices, costs), least_s + kBoundRounding_s);
      EXPECT_NEAR(bound_of_pruned(prices, costs), bound_of(prices, costs), kBoundRounding_s);
    }
    EXPECT_LE(best_bound(costs, {least_s, 0}).bound_s, least_s + kBoundRounding_s);
  });
}

// Tracks in a row 4 s from one to the next, and two rings: 3 s from the last track to the first ring, 5 s to
// the other one. All else is dear.
TEST(BestBound, OfRingsBehindTracksIsTheWayOverAll) {
  TableCosts costs(5);
  for (End a = 0; a < 10; ++a)
    for (End b = 0; b < a; ++b) costs.set(a, b, b % 2 == 1 && a == b + 1 ? 4 : 20);
  std::vector<double> first(10, 20), second(11, 20);
  first[9] = 3;
  second[10] = 5;
  costs.add_ring(first);
  costs.add_ring(second);
  EXPECT_NEAR(best_bound(costs, {24, 0}).bound_s, 4 * 4 + 3 + 5, 1e-6);
}

/// The definition, tree by tree: every choice of one join fewer than there are lines and gates that closes no
/// ring.
double bound_by_all_trees(const std::vector<double>& prices, const TableCosts& costs) {
  const std::size_t lines = costs.lines(), count = lines + costs.gates();
  const auto member = [&](std::size_t node) { return node < 2 * lines ? node / 2 : node - lines; };
  struct Join {
    std::size_t one, other;
    double cost_s;
  };
  std::vector<Join> joins;
  for (std::size_t a = 0; a < costs.nodes(); ++a)
    for (std::size_t b = 0; b < std::min(a, 2 * lines); ++b)
      if (member(a) != member(b))
        joins.push_back({member(a), member(b), costs.between(a, b) + prices[a] + prices[b]});
  double least = count == 1 ? 0 : std::numeric_limits<double>::max();
  std::vector<std::size_t> set(count);
  const auto go_on = [&](const auto& self, std::size_t first, std::size_t chosen, double sum,
                         std::vector<std::size_t> sets) -> void {
    if (chosen + 1 == count) {
      least = std::min(least, sum);
      return;
    }
    for (std::size_t i = first; i < joins.size(); ++i) {
      const std::size_t from = sets[joins[i].one], to = sets[joins[i].other];
      if (from == to) continue;
      std::vector<std::size_t> joined = sets;
      std::replace(joined.begin(), joined.end(), from, to);
      self(self, i + 1, chosen + 1, sum + joins[i].cost_s, std::move(joined));
    }
  };
  std::iota(set.begin(), set.end(), 0);
  go_on(go_on, 0, 0, 0, set);
  std::vector<double> of_lines(prices.begin(), prices.begin() + static_cast<std::ptrdiff_t>(2 * lines));
  std::sort(of_lines.begin(), of_lines.end());
  double out = least - std::accumulate(prices.begin(), prices.end(), 0.0);
  for (std::size_t i = 0; i + costs.gates() < 2; ++i) out += of_lines[i];
  return out;
}

TEST(BoundOf, IsThatOfTheLeastOfAllTrees) {
  testing::for_each_seed(60, [](std::mt19937_64& random, int number) {
    const TableCosts costs = random_case(number, number % 3 == 2 ? 3 : 4, random);
    const std::vector<double> prices = random_prices(costs, random);
    EXPECT_NEAR(bound_of(prices, costs), bound_by_all_trees(prices, costs), kBoundRounding_s);
  });
}

TEST(BoundOf, IsTheSameWithPruning) {
  testing::for_each_seed(60, [](std::mt19937_64& random, int number) {
    const TableCosts any = random_case(number, 40, random);
    const std::vector<double> prices = random_prices(any, random);
    EXPECT_NEAR(bound_of_pruned(prices, any), bound_of(prices, any), kBoundRounding_s);
  });
}

// Two groups of lines far apart, more than have neighbours across: the joins of near nodes leave them apart.
TEST(BoundOf, JoinsGroupsOfLinesFarApart) {
  TableCosts costs(60);
  for (End a = 0; a < 120; ++a)
    for (End b = 0; b < a; ++b) costs.set(a, b, (a < 60) == (b < 60) ? 1 : 100 + static_cast<double>(a + b));
  const std::vector<double> none(120, 0);
  EXPECT_EQ(bound_of(none, costs), 58 * 1 + 160);  // nodes 0 and 60
  EXPECT_EQ(bound_of_pruned(none, costs), bound_of(none, costs));
}

TEST(BestBound, IsAtMostTheLeastOfAllTours) {
  testing::for_each_seed(60, [](std::mt19937_64& random, int number) {
    const TableCosts costs = random_case(number, 7, random);
    const double least_s = testing::least_of_all_tours(costs);
    const PricedBound best = best_bound(costs, {least_s, 0});
    EXPECT_LE(best.bound_s, least_s + kBoundRounding_s);
    EXPECT_NEAR(best.bound_s, bound_of(best.prices_s, costs), kBoundRounding_s);
    EXPECT_GE(best.bound_s, bound_of(std::vector<double>(costs.nodes(), 0), costs) - kBoundRounding_s);
  });
}

// A route that is longer than the least one makes the steps too long at first, not the bound wrong.
TEST(BestBound, DoesNotDependOnTheKnownRouteToHold) {
  testing::for_each_seed(20, [](std::mt19937_64& random, int number) {
    const TableCosts costs = random_case(number, 6, random);
    const double least_s = testing::least_of_all_tours(costs);
    for (const double share : {0.0, 0.5, 2.0, 10.0})
      EXPECT_LE(best_bound(costs, {share * least_s, 0}).bound_s, least_s + kBoundRounding_s);
  });
}

// One line, and no gate: nothing to connect. With gates at 3 and at 4 s from its ends: both ways to them.
TEST(BestBound, OfOneLineIsItsWayToTheGates) {
  TableCosts costs(1);
  EXPECT_EQ(best_bound(costs, {0, 0}).bound_s, 0);
  costs.set_gates({3, 9}, {9, 4});
  EXPECT_NEAR(best_bound(costs, {7, 0}).bound_s, 7, 1e-6);
}

// U turns, 2 radii wide or more, from each track to the next.
TEST(BestBound, OfWideTracksIsTheClosedForm) {
  for (const double width : {12.0, 24.0}) {
    const TableCosts costs = testing::dubins_costs(testing::rectangle(40, width, 100), 6);
    const double least_s = 39 * (M_PI * 6 + width - 12) / 2;
    EXPECT_NEAR(best_bound(costs, {least_s, 0}).bound_s, least_s, 1e-6);
  }
}

// Narrow tracks, which are best driven with jumps of 4 and a few others: no closed form is known, but the
// bound meets what the search finds.
TEST(BestBound, OfNarrowTracksMeetsTheSearch) {
  for (const std::size_t tracks : {20U, 40U, 77U, 150U}) {
    const TableCosts costs = testing::dubins_costs(testing::rectangle(tracks, 3, 100), 6);
    const Neighbours near = costs.neighbours();
    const double found_s =
        connection_s(shortened(greedy_tour(costs, near), costs, near, usual_kicks(tracks)), costs);
    const double bound_s = best_bound(costs, {found_s, 0}).bound_s;
    EXPECT_LE(bound_s, found_s + kBoundRounding_s);
    EXPECT_GE(bound_s, 0.99 * found_s) << tracks << " tracks";
    EXPECT_GE(found_s,
              static_cast<double>(tracks - 1) * M_PI * 6 / 2);  // each turn is half a circle at least
  }
}

// An ascent that ends near enough proves that much, and no more than the whole one may.
TEST(BestBound, EndsNearEnough) {
  const TableCosts costs = testing::dubins_costs(testing::rectangle(60, 3, 100), 6);
  const Neighbours near = costs.neighbours();
  const double found_s =
      connection_s(shortened(greedy_tour(costs, near), costs, near, usual_kicks(60)), costs);
  const double whole_s = best_bound(costs, {found_s, 0}).bound_s;
  const PricedBound early = best_bound(costs, {found_s, 0, 0.1 * found_s});
  EXPECT_GE(early.bound_s, 0.9 * found_s);
  EXPECT_LT(early.bound_s, whole_s);
  EXPECT_NEAR(early.bound_s, bound_of(early.prices_s, costs), kBoundRounding_s);
}

// Which nodes are near decides how soon the prices are found, not what they prove: the joins that lack are
// added. Every third neighbour is left out.
TEST(BestBound, IsProvenFromAnyNearNodes) {
  testing::for_each_seed(20, [](std::mt19937_64& random, int) {
    const TableCosts costs = testing::dubins_costs(testing::random_field_lines(40, 6, random), 6);
    Neighbours near = costs.neighbours();
    const double found_s =
        connection_s(shortened(greedy_tour(costs, near), costs, near, usual_kicks(40)), costs);
    for (std::vector<End>& ends : near)
      for (std::size_t i = ends.size(); i-- > 0;)
        if (i % 3 == 0) ends.erase(ends.begin() + static_cast<std::ptrdiff_t>(i));
    const PricedBound bound = best_bound(costs, near, {found_s, 0});
    EXPECT_LE(bound.bound_s, found_s + kBoundRounding_s);
    EXPECT_NEAR(bound.bound_s, bound_of(bound.prices_s, costs), kBoundRounding_s);
    EXPECT_NEAR(bound.bound_s, best_bound(costs, {found_s, 0}).bound_s, 0.02 * found_s);
  });
}

TEST(BestBound, IsTheSameEveryTime) {
  testing::for_each_seed(3, [](std::mt19937_64& random, int) {
    const TableCosts costs = testing::dubins_costs(testing::random_field_lines(100, 6, random), 6);
    const PricedBound one = best_bound(costs, {2000, 0}), other = best_bound(costs, {2000, 0});
    EXPECT_EQ(one.bound_s, other.bound_s);
    EXPECT_EQ(one.prices_s, other.prices_s);
  });
}

// With exact lower-lower bounds hardly any cost is asked for twice: far fewer than all pairs.
TEST(BestBound, AsksForFewExactTimes) {
  class Counting final : public ConnectionBounds {
   public:
    explicit Counting(const TableCosts& costs) : costs_(costs) {}
    std::size_t lines() const override { return costs_.lines(); }
    std::size_t gates() const override { return 0; }
    double between(std::size_t a, std::size_t b) const override {
      ++asked;
      return costs_.between(a, b);
    }
    double least(std::size_t a, std::size_t b) const override { return 0.7 * costs_.between(a, b); }
    mutable std::size_t asked = 0;

   private:
    const TableCosts& costs_;
  };
  const TableCosts costs = testing::dubins_costs(testing::rectangle(300, 6, 200), 6);
  const Counting counting(costs);
  best_bound(counting, {8000, 0});
  EXPECT_LT(counting.asked, 600U * 600U / 4);
}

}  // namespace
}  // namespace tramline::order
