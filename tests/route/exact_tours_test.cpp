// Tours and bounds against integer programming, which proves the least tour of dozens of lines. The search
// may miss it by kMostAbove, the bound the least of the linear relaxation by kMostBelow.

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "properties/draws.h"
#include "properties/seeds.h"
#include "route/exact/tour_program.h"
#include "route/scenes.h"
#include "tramline/route/certificate/best_bound.h"
#include "tramline/route/search/best_order_exactly.h"
#include "tramline/route/search/first_tours.h"
#include "tramline/route/search/shortened.h"

namespace tramline::order {
namespace {

using testing::TableCosts;

constexpr double kMostAbove = 0.02;
constexpr double kMostBelow = 0.005;
/// Solvers take rows as kept that miss by less than this.
constexpr double kSolver_s = 1e-4;
constexpr double kEnough_s = 20;
/// Times as many kicks as usual, which are enough in nearly all cases.
constexpr std::size_t kOften = 6;

TableCosts random_lines(std::size_t lines, int number, std::mt19937_64& random) {
  TableCosts costs = testing::dubins_costs(testing::random_field_lines(lines, uniform(random, 3, 12), random),
                                           uniform(random, 4, 8));
  testing::add_gates(static_cast<std::size_t>(number % 3), costs, random);
  return costs;
}

TEST(ExactTours, OfUpToElevenLinesAreThoseOfDynamicProgramming) {
  testing::for_each_seed(9, [](std::mt19937_64& random, int number) {
    const auto lines = static_cast<std::size_t>(9 + number % 3);
    const TableCosts costs = random_lines(lines, number, random);
    const double found_s = connection_s(best_order_exactly(costs), costs);
    // A little more is known than there is to find, so that the solver has to find it.
    const testing::LeastTour least = testing::least_tour(costs, found_s + 1, kEnough_s);
    ASSERT_TRUE(least.proven);
    EXPECT_NEAR(least.least_s, found_s, kSolver_s);
    EXPECT_LE(least.relaxed_s, found_s + kSolver_s);
  });
}

// 40 cases: TRAMLINE_CASES=40.
TEST(ExactTours, OfDozensOfLinesAreNearlyFoundAndNearlyProven) {
  int proven = 0, asked = 0;
  testing::for_each_seed(4, [&](std::mt19937_64& random, int number) {
    const auto lines = static_cast<std::size_t>(any_of(random, 20, 60));
    const TableCosts costs = random_lines(lines, number, random);
    const Neighbours near = costs.neighbours();
    const double found_s =
        connection_s(shortened(greedy_tour(costs, near), costs, near, kOften * usual_kicks(lines)), costs);
    const double bound_s = best_bound(costs, {found_s, 0}).bound_s;
    const testing::LeastTour least = testing::least_tour(costs, found_s, kEnough_s);
    ++asked;
    EXPECT_LE(bound_s, least.relaxed_s + kSolver_s);
    EXPECT_GE(bound_s, (1 - kMostBelow) * least.relaxed_s);
    if (!least.proven) return;
    ++proven;
    EXPECT_LE(least.least_s, found_s + kSolver_s);
    EXPECT_LE(found_s, (1 + kMostAbove) * least.least_s);
    EXPECT_LE(bound_s, least.least_s + kSolver_s);
  });
  EXPECT_GE(2 * proven, asked) << "the solver ran out of time too often";
}

}  // namespace
}  // namespace tramline::order
