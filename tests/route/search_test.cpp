// The search for an order of lines, against all orders.

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <random>
#include <set>
#include <vector>

#include "properties/draws.h"
#include "properties/seeds.h"
#include "route/brute_force.h"
#include "route/scenes.h"
#include "tramline/route/search/best_order_exactly.h"
#include "tramline/route/search/first_tours.h"
#include "tramline/route/search/shortened.h"

namespace tramline::order {
namespace {

using testing::TableCosts;

constexpr double kRounding_s = 1e-9;

bool has_every_line_once(const Tour& tour, std::size_t lines) {
  std::set<std::size_t> driven;
  for (const End entered : tour) driven.insert(line_of(entered));
  return tour.size() == lines && driven.size() == lines && (lines == 0 || *driven.rbegin() + 1 == lines);
}

Tour random_tour(std::size_t lines, std::mt19937_64& random) {
  Tour out(lines);
  for (std::size_t i = 0; i < lines; ++i) out[i] = 2 * i + static_cast<std::size_t>(any_of(random, 0, 1));
  std::shuffle(out.begin(), out.end(), random);
  return out;
}

// Lines 0 and 1 of 3: start 5 + end of 0 to start of 1 + finish.
TEST(ConnectionSeconds, AreThoseBetweenBeforeAndAfter) {
  TableCosts costs(2);
  costs.set(1, 2, 7);
  costs.set(0, 2, 11);
  costs.set_gates({5, 50, 500, 5000}, {3, 30, 300, 3000});
  EXPECT_EQ(connection_s({0, 2}, costs), 5 + 7 + 3000);
  EXPECT_EQ(connection_s({1, 2}, costs), 50 + 11 + 3000);
  EXPECT_EQ(connection_s({3, 1}, costs), 5000 + 7 + 3);
}

TEST(BestOrderExactly, IsTheLeastOfAllTours) {
  testing::for_each_seed(60, [](std::mt19937_64& random, int number) {
    const std::size_t lines = number == 0 ? 8 : static_cast<std::size_t>(any_of(random, 1, 7));
    TableCosts costs = testing::random_costs(lines, random);
    testing::add_gates(static_cast<std::size_t>(number % 3), costs, random);
    const Tour tour = best_order_exactly(costs);
    ASSERT_TRUE(has_every_line_once(tour, lines));
    EXPECT_NEAR(connection_s(tour, costs), testing::least_of_all_tours(costs), kRounding_s);
  });
}

TEST(BestOrderExactly, OfNoLinesHasNone) { EXPECT_TRUE(best_order_exactly(TableCosts(0)).empty()); }

TEST(Shortened, FindsTheLeastOfAllToursOfFewLines) {
  testing::for_each_seed(60, [](std::mt19937_64& random, int number) {
    const std::size_t lines = number == 0 ? 8 : static_cast<std::size_t>(any_of(random, 2, 7));
    TableCosts costs = testing::random_costs(lines, random);
    testing::add_gates(static_cast<std::size_t>(number % 3), costs, random);
    const Tour tour = shortened(random_tour(lines, random), costs, costs.neighbours(), 500);
    ASSERT_TRUE(has_every_line_once(tour, lines));
    EXPECT_NEAR(connection_s(tour, costs), testing::least_of_all_tours(costs), kRounding_s);
  });
}

TEST(Shortened, FindsTheLeastOrderOfUpToElevenLines) {
  testing::for_each_seed(12, [](std::mt19937_64& random, int number) {
    const auto lines = static_cast<std::size_t>(9 + number % 3);
    const TableCosts costs =
        testing::dubins_costs(testing::random_field_lines(lines, uniform(random, 3, 12), random), 6);
    const Tour tour = shortened(random_tour(lines, random), costs, costs.neighbours(), usual_kicks(lines));
    EXPECT_NEAR(connection_s(tour, costs), connection_s(best_order_exactly(costs), costs), kRounding_s);
  });
}

TEST(Shortened, NeverLosesTheBestTour) {
  testing::for_each_seed(30, [](std::mt19937_64& random, int) {
    const auto lines = static_cast<std::size_t>(any_of(random, 2, 60));
    const TableCosts costs =
        testing::dubins_costs(testing::random_field_lines(lines, uniform(random, 3, 12), random), 6);
    const Neighbours neighbours = costs.neighbours();
    const Tour first = random_tour(lines, random);
    double before_s = connection_s(first, costs);  // then what local search alone finds
    for (const std::size_t kicks : {0, 1, 5, 25, 125, 625}) {
      const Tour tour = shortened(first, costs, neighbours, kicks);
      ASSERT_TRUE(has_every_line_once(tour, lines));
      const double now_s = connection_s(tour, costs);
      EXPECT_LE(now_s, before_s + kRounding_s) << kicks << " kicks";
      if (kicks == 0) before_s = now_s;
    }
  });
}

TEST(Shortened, IsTheSameEveryTime) {
  testing::for_each_seed(5, [](std::mt19937_64& random, int) {
    const TableCosts costs = testing::dubins_costs(testing::random_field_lines(80, 6, random), 6);
    const Tour first = random_tour(80, random);
    EXPECT_EQ(shortened(first, costs, costs.neighbours(), 300),
              shortened(first, costs, costs.neighbours(), 300));
  });
}

TEST(Shortened, OfSeveralToursIsNoWorseThanAnyAfterItsPartOfTheKicks) {
  testing::for_each_seed(10, [](std::mt19937_64& random, int) {
    const auto lines = static_cast<std::size_t>(any_of(random, 12, 60));
    const TableCosts costs = testing::dubins_costs(testing::random_field_lines(lines, 6, random), 6);
    const Neighbours near = costs.neighbours();
    const std::vector<Tour> tours{random_tour(lines, random), greedy_tour(costs, near)};
    const Tour best = shortened_best(tours, costs, near, 200);
    ASSERT_TRUE(has_every_line_once(best, lines));
    for (const Tour& tour : tours)
      EXPECT_LE(connection_s(best, costs),
                connection_s(shortened(tour, costs, near, 50), costs) + kRounding_s);
  });
}

// U turns, 2 radii wide or more: the next track is the nearest, so no order beats up and down.
TEST(Shortened, DrivesWideTracksUpAndDown) {
  for (const double width : {12.0, 24.0}) {
    std::mt19937_64 random(1);
    const TableCosts costs = testing::dubins_costs(testing::rectangle(40, width, 100), 6);
    const Tour tour = shortened(random_tour(40, random), costs, costs.neighbours(), usual_kicks(40));
    EXPECT_NEAR(connection_s(tour, costs), 39 * (M_PI * 6 + width - 12) / 2, 1e-6);
  }
}

TEST(GreedyTour, HasEveryLineOnceAndStartsWell) {
  testing::for_each_seed(30, [](std::mt19937_64& random, int number) {
    const auto lines = static_cast<std::size_t>(any_of(random, 1, 80));
    TableCosts costs =
        testing::dubins_costs(testing::random_field_lines(lines, uniform(random, 3, 12), random), 6);
    testing::add_gates(static_cast<std::size_t>(number % 3), costs, random);
    const Tour tour = greedy_tour(costs, costs.neighbours());
    ASSERT_TRUE(has_every_line_once(tour, lines));
    if (lines < 10) return;
    double random_s = 0;
    for (int i = 0; i < 10; ++i) random_s += connection_s(random_tour(lines, random), costs) / 10;
    EXPECT_LT(connection_s(tour, costs), random_s);
  });
}

// Of two lines beside one another the prices say which of their ends are joined.
TEST(GreedyTour, JoinsEndsOfLowPricesFirst) {
  const TableCosts costs = testing::dubins_costs(testing::rectangle(2, 24, 100), 6);
  EXPECT_EQ(greedy_tour(costs, costs.neighbours(), {0, 0, 9, 9}), greedy_tour(costs, costs.neighbours()));
  EXPECT_EQ(greedy_tour(costs, costs.neighbours(), {0, -9, 0, -9}), (Tour{0, 3}));
  EXPECT_EQ(greedy_tour(costs, costs.neighbours(), {-9, 0, -9, 0}), (Tour{1, 2}));
}

// Without neighbours nothing is joined at first: then each line is a piece, and the nearest follows.
TEST(GreedyTour, GoesToTheNearestEndWhereThereAreNoNeighbours) {
  const TableCosts costs = testing::dubins_costs(testing::rectangle(5, 24, 100), 6);
  EXPECT_EQ(greedy_tour(costs, Neighbours(10)), (Tour{0, 3, 4, 7, 8}));
}

TEST(EnteredBest, IsTheBestOfAllWaysToEnterTheLines) {
  testing::for_each_seed(30, [](std::mt19937_64& random, int number) {
    const auto lines = static_cast<std::size_t>(any_of(random, 1, 8));
    TableCosts costs = testing::random_costs(lines, random);
    testing::add_gates(static_cast<std::size_t>(number % 3), costs, random);
    std::vector<std::size_t> order(lines);
    std::iota(order.begin(), order.end(), 0);
    std::shuffle(order.begin(), order.end(), random);
    double least_s = std::numeric_limits<double>::max();
    for (std::size_t sides = 0; sides < std::size_t{1} << lines; ++sides) {
      Tour tour;
      for (std::size_t i = 0; i < lines; ++i) tour.push_back(2 * order[i] + (sides >> i & 1U));
      least_s = std::min(least_s, connection_s(tour, costs));
    }
    const Tour tour = entered_best(order, costs);
    for (std::size_t i = 0; i < lines; ++i) EXPECT_EQ(line_of(tour[i]), order[i]);
    EXPECT_NEAR(connection_s(tour, costs), least_s, kRounding_s);
  });
}

}  // namespace
}  // namespace tramline::order
