// The parts of the search for an order: neighbours, moves, patterns.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include "properties/draws.h"
#include "properties/seeds.h"
#include "route/scenes.h"
#include "tramline/route/order/land_pattern.h"
#include "tramline/route/search/closed_tour.h"
#include "tramline/route/search/double_bridge.h"
#include "tramline/route/search/neighbours.h"
#include "tramline/route/search/three_opt.h"
#include "tramline/route/search/two_opt.h"

namespace tramline::order {
namespace {

using testing::TableCosts;

constexpr double kSumRounding_s = 1e-9;

// Nodes on a line at 0, 1, 10, 11, 20, 21: of the pairs (0, 1), (2, 3), (4, 5) none are neighbours.
TEST(NearNodes, AreTheNearestOfOtherLines) {
  const std::vector<double> at{0, 1, 10, 11, 20, 21};
  const auto far = [&](std::size_t a, std::size_t b) { return std::abs(at[a] - at[b]); };
  const Neighbours two = neighbours_of(6, far, far, {2, 2});
  EXPECT_EQ(two[0], (std::vector<std::size_t>{2, 3}));
  EXPECT_EQ(two[3], (std::vector<std::size_t>{4, 1}));  // 9 and 10 away; node 5 is 10 away too
  EXPECT_EQ(two[5], (std::vector<std::size_t>{3, 2}));
}

// The estimate says which are looked at, the cost which are kept.
TEST(NearNodes, AreKeptByCost) {
  const auto estimate = [](std::size_t a, std::size_t b) { return std::abs(double(a) - double(b)); };
  const auto cost = [](std::size_t a, std::size_t b) { return -std::abs(double(a) - double(b)); };
  const Neighbours near = neighbours_of(10, estimate, cost, {3, 2});
  EXPECT_EQ(near[0], (std::vector<std::size_t>{4, 3}));  // of 2, 3 and 4
  EXPECT_EQ(near[5], (std::vector<std::size_t>{3, 7}));  // of 6, 3 and 7
}

struct MovingTour {
  TableCosts costs;
  Tour tour;
  ClosedCosts closed;
  ClosedTour ring;

  MovingTour(std::size_t lines, std::mt19937_64& random)
      : costs(with_gates(lines, random)), tour(shuffled(lines, random)), closed(costs), ring(tour, closed) {}

  double now_s() const { return connection_s(ring.open(), costs); }
  End any_end(std::mt19937_64& random) const {
    return static_cast<End>(any_of(random, 0, static_cast<int>(2 * ring.lines()) - 1));
  }
  bool joins(End a, End b) const { return ring.mate(a) == b && ring.mate(b) == a; }

 private:
  static TableCosts with_gates(std::size_t lines, std::mt19937_64& random) {
    TableCosts out = testing::random_costs(lines, random);
    testing::add_gates(2, out, random);
    return out;
  }
  static Tour shuffled(std::size_t lines, std::mt19937_64& random) {
    Tour out;
    for (std::size_t i = 0; i < lines; ++i)
      out.push_back(2 * i + static_cast<std::size_t>(any_of(random, 0, 1)));
    std::shuffle(out.begin(), out.end(), random);
    return out;
  }
};

TEST(ClosedTour, OpensToTheTourItWasMadeOf) {
  testing::for_each_seed(20, [](std::mt19937_64& random, int) {
    const MovingTour moving(static_cast<std::size_t>(any_of(random, 1, 12)), random);
    EXPECT_EQ(moving.ring.open(), moving.tour);
    EXPECT_EQ(moving.ring.mate(moving.ring.start()), moving.tour.front());
    EXPECT_EQ(moving.ring.mate(moving.ring.finish()), other_end(moving.tour.back()));
  });
}

TEST(TwoOpt, ConnectsItsEndsAndGainsWhatItSays) {
  testing::for_each_seed(200, [](std::mt19937_64& random, int) {
    MovingTour moving(static_cast<std::size_t>(any_of(random, 2, 12)), random);
    const End a = moving.any_end(random), b = moving.any_end(random);
    const End mate_of_a = moving.ring.mate(a), mate_of_b = moving.ring.mate(b);
    const TwoOpt move(moving.ring, a, b);
    if (!move.is_valid()) return;
    const double before_s = moving.now_s(), gain = move.gain(moving.ring);
    move.apply(moving.ring);
    EXPECT_TRUE(moving.joins(a, b));
    EXPECT_TRUE(moving.joins(mate_of_a, mate_of_b));
    EXPECT_NEAR(before_s - moving.now_s(), gain, kSumRounding_s);
    moving.ring.undo_to(0);
    EXPECT_EQ(moving.ring.open(), moving.tour);
  });
}

TEST(ThreeOpt, ConnectsItsEndsAndGainsWhatItSays) {
  int applied = 0;
  testing::for_each_seed(600, [&](std::mt19937_64& random, int) {
    MovingTour moving(static_cast<std::size_t>(any_of(random, 2, 12)), random);
    const End a = moving.any_end(random), b = moving.any_end(random), c = moving.any_end(random);
    const End mate_of_a = moving.ring.mate(a), mate_of_b = moving.ring.mate(b),
              mate_of_c = moving.ring.mate(c);
    const ThreeOpt move(moving.ring, a, b, c);
    if (!move.is_valid()) return;
    ++applied;
    const double before_s = moving.now_s(), gain = move.gain(moving.ring);
    move.apply(moving.ring);
    EXPECT_TRUE(moving.joins(mate_of_a, b));
    EXPECT_TRUE(moving.joins(mate_of_b, c));
    EXPECT_TRUE(moving.joins(mate_of_c, a));
    EXPECT_NEAR(before_s - moving.now_s(), gain, kSumRounding_s);
    moving.ring.undo_to(0);
    EXPECT_EQ(moving.ring.open(), moving.tour);
  });
  if (testing::case_count(600) >= 600) {
    EXPECT_GT(applied, 100);
  }
}

/// Whether connecting these ends, all others left as they are, makes one ring of all lines.
bool makes_one_ring(const ClosedTour& ring, End a, End b, End c) {
  std::vector<End> mate(2 * ring.lines());
  for (End end = 0; end < mate.size(); ++end) mate[end] = ring.mate(end);
  const std::vector<std::pair<End, End>> joins{{mate[a], b}, {mate[b], c}, {mate[c], a}};
  for (const auto& [from, to] : joins) {
    mate[from] = to;
    mate[to] = from;
  }
  std::size_t lines = 0;
  End at = 0;
  do {
    at = mate[other_end(at)];
    ++lines;
  } while (at != 0 && lines <= ring.lines());
  return lines == ring.lines();
}

TEST(ThreeOpt, IsValidJustWhereOneRingResults) {
  testing::for_each_seed(40, [](std::mt19937_64& random, int) {
    const MovingTour moving(static_cast<std::size_t>(any_of(random, 2, 7)), random);
    const ClosedTour& ring = moving.ring;
    const std::size_t ends = 2 * ring.lines();
    for (End a = 0; a < ends; ++a)
      for (End b = 0; b < ends; ++b)
        for (End c = 0; c < ends; ++c) {
          const bool three =
              b != a && b != ring.mate(a) && c != a && c != ring.mate(a) && c != b && c != ring.mate(b);
          EXPECT_EQ(ThreeOpt(ring, a, b, c).is_valid(), three && makes_one_ring(ring, a, b, c))
              << a << " " << b << " " << c;
        }
  });
}

// Of A B C D in a ring: A D C B, each as it was driven.
TEST(DoubleBridge, ChangesTheOrderOfRunsAndTurnsNone) {
  const TableCosts costs(8);
  ClosedCosts closed(costs);
  ClosedTour ring({0, 2, 5, 6, 9, 10, 12, 15}, closed);
  DoubleBridge(1, {2, 1, 3}).apply(ring);
  EXPECT_EQ(ring.open(), (Tour{0, 9, 10, 12, 6, 2, 5, 15}));
}

TEST(DoubleBridge, GainsWhatItSaysAndIsUndone) {
  testing::for_each_seed(200, [](std::mt19937_64& random, int) {
    MovingTour moving(static_cast<std::size_t>(any_of(random, 3, 20)), random);
    std::array<std::size_t, 3> counts{};
    for (std::size_t& count : counts) count = static_cast<std::size_t>(any_of(random, 0, 6));
    const DoubleBridge kick(line_of(moving.any_end(random)), counts);
    if (!kick.is_valid(moving.ring)) return;
    const double before_s = moving.now_s(), gain = kick.gain(moving.ring);
    kick.apply(moving.ring);
    EXPECT_NEAR(before_s - moving.now_s(), gain, kSumRounding_s);
    moving.ring.undo_to(0);
    EXPECT_EQ(moving.ring.open(), moving.tour);
  });
}

TEST(LandPattern, GoesFromBothSidesInwards) {
  EXPECT_EQ(land_pattern(5, 5), (std::vector<std::size_t>{0, 4, 1, 3, 2}));
  EXPECT_EQ(land_pattern(7, 4), (std::vector<std::size_t>{0, 3, 1, 2, 4, 6, 5}));
  EXPECT_EQ(land_pattern(3, 1), (std::vector<std::size_t>{0, 1, 2}));
  EXPECT_EQ(land_pattern(2, 9), (std::vector<std::size_t>{0, 1}));
  EXPECT_TRUE(land_pattern(0, 3).empty());
}

}  // namespace
}  // namespace tramline::order
