// Bounds of a strip's rows by hand, and below what moved boundaries cost, row by row.

#include "tramline/cost/bound/row_cost_bound.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "properties/random_field.h"
#include "properties/seeds.h"

namespace tramline {
namespace {

// A boundary at x = 0.75 up ten rows of a strip of 4 m, the region on its left. Half a metre to and fro, and
// the rows stay cheapest unworked: from 4/3 m of land on they would be worked.
TEST(RowCostBound, OfAStraightEdgeIsWhatItCosts) {
  const std::vector<BoundaryPart> edge{{{0.75, 0}, {0.75, 10}}};
  const RowBoundTerms terms{4, 1, 2, 5, 0, 0.5};  // w, λo, λu, pivot, turn, shift
  const RowBounds bounds = row_cost_bound(edge, terms);
  EXPECT_NEAR(bounds.apart, 2 * 0.25 * 10, 1e-12);
  EXPECT_NEAR(bounds.together.constant, 2 * 0.75 * 10, 1e-12);
  EXPECT_NEAR(bounds.together.per_shift, 2 * 10, 1e-12) << "with the boundary to the right goes more land";
  EXPECT_NEAR(bounds.together.per_turn, 0, 1e-12) << "the pivot is in the middle";
  EXPECT_NEAR(inside_rows(edge, terms), 0.25 * 10, 1e-12);
}

// The same edge run down: 3 m of each row are land, and the rest, 1 m, is worked in vain.
TEST(RowCostBound, OfAnEdgeOnTheOtherSideGrowsTheOtherWay) {
  const std::vector<BoundaryPart> edge{{{1, 10}, {1, 0}}};
  const RowBounds bounds = row_cost_bound(edge, {4, 1, 2, 0, 0, 0.5});
  EXPECT_NEAR(bounds.apart, 0.5 * 10, 1e-12);
  EXPECT_NEAR(bounds.together.constant, 1 * 10, 1e-12);
  EXPECT_NEAR(bounds.together.per_shift, 1 * 10, 1e-12);
  EXPECT_NEAR(bounds.together.per_turn, 10 * 5, 1e-12) << "∫ y dy from the pivot at 0";
}

// Rows from y = 4 to y = 6 are not driven: 3 m of land in each of them, less the half metre that it may move.
TEST(RowCostBound, OfUndrivenRowsIsThatOfTheirLand) {
  const std::vector<BoundaryPart> edge{{{1, 10}, {1, 0}}};
  const RowBounds bounds = row_cost_bound(edge, {4, 1, 2, 5, 0, 0.5}, Intervals{{4, 6}});
  EXPECT_NEAR(bounds.apart, 0.5 * 8 + 2 * 2.5 * 2, 1e-12);
  EXPECT_NEAR(bounds.together.constant, 1 * 8 + 2 * 3 * 2, 1e-12);
  EXPECT_NEAR(bounds.together.per_shift, 1 * 8 - 2 * 2, 1e-12)
      << "with the land in undriven rows goes a cost";
}

TEST(RowCostBound, TheFarthestMoveIsAtTheEndFartherFromThePivot) {
  const RowBoundTerms terms{4, 1, 1, 10, 0.1, 0.5};
  EXPECT_NEAR(most_shift(2, 12, terms), 0.5 + 0.1 * 8, 1e-12);
  EXPECT_NEAR(most_shift(9, 30, terms), 0.5 + 0.1 * 20, 1e-12);
}

TEST(AffineBound, IsLeastAndMostAtTheEndsOfBothMoves) {
  const AffineBound bound{5, -2, 3};
  EXPECT_NEAR(bound.least(1, 0.5), 5 - 2 - 1.5, 1e-12);
  EXPECT_NEAR(bound.most(1, 0.5), 5 + 2 + 1.5, 1e-12);
  AffineBound sum = bound;
  sum += {1, 1, 1};
  sum -= {0, 0, 4};
  EXPECT_EQ(sum.constant, 6);
  EXPECT_EQ(sum.per_shift, -1);
  EXPECT_EQ(sum.per_turn, 0);
}

/// What lies in the strip [0, w] of the rows of a ring that has moved, and what those rows cost.
struct MovedRows {
  double land_m2 = 0;
  double cost = 0;
};

double land_in_row(const Ring& ring, double y, double width_m) {
  std::vector<double> passed;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Point a = ring[i], b = ring[(i + 1) % ring.size()];
    if ((a.y <= y) != (b.y <= y)) passed.push_back(a.x + (b.x - a.x) * (y - a.y) / (b.y - a.y));
  }
  std::sort(passed.begin(), passed.end());
  double sum = 0;
  for (std::size_t i = 0; i + 1 < passed.size(); i += 2)
    sum += std::clamp(passed[i + 1], 0.0, width_m) - std::clamp(passed[i], 0.0, width_m);
  return sum;
}

MovedRows moved_rows(Ring ring, double by, double turn, const RowBoundTerms& terms,
                     const Intervals& undriven) {
  constexpr int kRows = 6000;
  for (Point& p : ring) p.x += by + turn * (p.y - terms.pivot_along);
  const Box reach = bounds(ring);
  const double step = reach.height() / kRows;
  MovedRows out;
  for (int i = 0; i < kRows; ++i) {
    const double y = reach.min_y + (i + 0.5) * step, land = land_in_row(ring, y, terms.width_m);
    const bool is_undriven = std::any_of(undriven.begin(), undriven.end(),
                                         [y](const Interval& one) { return one.from < y && y < one.to; });
    out.land_m2 += step * land;
    out.cost +=
        step * (is_undriven ? terms.under_price * land
                            : std::min(terms.over_price * (terms.width_m - land), terms.under_price * land));
  }
  return out;
}

class RandomRows {
 public:
  RandomRows(std::mt19937_64& random, int number) {
    std::uniform_real_distribution<double> width(2, 25), price(0.01, 1), along(-40, 40), share(0, 1);
    ring = testing::random_star(random, {6, -5}, 12, 50, 3 + number % 12);
    terms = {width(random), price(random), price(random), along(random), 0, 0};
    if (number % 4 != 0) terms.shift = 0.3 * share(random) * terms.width_m;
    if (number % 3 == 0) terms.turn = 0.02 * share(random);
    if (number % 2 == 0) {
      const double from = along(random);
      undriven = {{from, from + 10}, {from + 15, from + 16}};
    }
    // Every part that can come into the strip.
    const StripGrid grid{TrackFrame(), 0, terms.width_m};
    cut_.collect({ring}, grid, {0, 0}, terms.shift + terms.turn * 120);
    parts = cut_.in(0);
    std::sort(parts.begin(), parts.end(),
              [](const BoundaryPart& a, const BoundaryPart& b) { return a.lowest() < b.lowest(); });
  }

  Ring ring;
  RowBoundTerms terms;
  Intervals undriven;
  std::span<BoundaryPart> parts;

 private:
  StripParts cut_;
};

TEST(RowCostBound, LiesBelowTheCostOfEveryMove) {
  testing::for_each_seed(80, [](std::mt19937_64& random, int number) {
    const RandomRows rows(random, number);
    const RowBounds bounds = row_cost_bound(rows.parts, rows.terms, rows.undriven);
    const double least_m2 = inside_rows(rows.parts, rows.terms);
    std::uniform_real_distribution<double> share(-1, 1);
    for (int i = 0; i < 10; ++i) {
      // Bounds are most at risk where the boundary moves as far as it may.
      const double e = rows.terms.shift * (i < 2 ? 1 - 2 * i : share(random));
      const double a = rows.terms.turn * (i < 4 ? 1 - 2 * (i % 2) : share(random));
      const MovedRows moved = moved_rows(rows.ring, e, a, rows.terms, rows.undriven);
      const double rounding = 1e-3 * (1 + moved.cost);
      ASSERT_LE(bounds.apart, moved.cost + rounding) << "moved by " << e << " and " << a;
      const AffineBound& all = bounds.together;
      ASSERT_LE(all.constant + e * all.per_shift + a * all.per_turn, moved.cost + rounding)
          << "moved by " << e << " and " << a;
      // Whole rows, which no part can come into, are land as well.
      ASSERT_LE(least_m2, moved.land_m2 + 1e-3 * (1 + moved.land_m2));
    }
  });
}

TEST(RowCostBound, OfABoundaryThatStaysIsItsCost) {
  testing::for_each_seed(40, [](std::mt19937_64& random, int number) {
    const RandomRows rows(random, 12 * number + (number % 2 == 0 ? 4 : 8));  // neither shift nor turn
    ASSERT_EQ(rows.terms.shift + rows.terms.turn, 0);
    const RowBounds bounds = row_cost_bound(rows.parts, rows.terms, {});
    const double cost = moved_rows(rows.ring, 0, 0, rows.terms, {}).cost;
    ASSERT_NEAR(bounds.apart, cost, 1e-3 * (1 + cost));
    // Chords lie below the kink of the cost, but span no more than an eighth of the width.
    ASSERT_GE(bounds.together.constant, 0.75 * cost - 1e-3);
  });
}

}  // namespace
}  // namespace tramline
