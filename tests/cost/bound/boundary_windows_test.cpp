// Windows by looking at all parts, and the cost of a passage by trying ends.

#include "tramline/cost/bound/boundary_windows.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

#include "properties/random_field.h"
#include "properties/seeds.h"

namespace tramline {
namespace {

std::vector<BoundaryWindow> windows_of(std::span<BoundaryPart> parts, double width_m, double margin_m,
                                       double apart_m) {
  std::vector<BoundaryWindow> out(3);  // what was in it before does not matter
  gather_windows(parts, width_m, margin_m, apart_m, out);
  return out;
}

// A field 4 m wide in a strip of 4 m: it begins at y = 0, square to the strip, and ends along a line that
// falls by half a metre a metre. 10 m on a triangle stands in from the right, over the middle line.
TEST(BoundaryWindows, ShowWhatTheBoundaryDoesInThem) {
  std::vector<BoundaryPart> parts{
      {{4, 8}, {0, 10}}, {{0, 0}, {4, 0}}, {{4, 20}, {1, 21}}, {{1, 21}, {4, 22}}};
  const std::vector<BoundaryWindow> windows = windows_of(parts, 4, 0, 1);
  ASSERT_EQ(windows.size(), 3u);
  EXPECT_TRUE(windows[0].passes);
  EXPECT_TRUE(windows[0].begins);
  EXPECT_TRUE(windows[0].inside_after);
  EXPECT_EQ(windows[0].across_m, 4);
  EXPECT_EQ(windows[0].least_slope, 0);
  EXPECT_EQ(windows[0].most_slope, 0);

  EXPECT_EQ(windows[1].lowest, 8);
  EXPECT_EQ(windows[1].highest, 10);
  EXPECT_TRUE(windows[1].passes);
  EXPECT_FALSE(windows[1].begins);
  EXPECT_FALSE(windows[1].inside_after);
  EXPECT_NEAR(windows[1].most_slope, 0.5, 1e-12);

  EXPECT_EQ(windows[2].parts.size(), 2u);
  EXPECT_FALSE(windows[2].passes);
  EXPECT_FALSE(windows[2].inside_after);
  EXPECT_NEAR(windows[2].across_m, 6, 1e-12);
  EXPECT_NEAR(windows[2].least_slope, 1.0 / 3, 1e-12);
}

TEST(BoundaryWindows, AreOneWherePartsAreNoFartherApart) {
  std::vector<BoundaryPart> parts{{{0, 0}, {4, 0}}, {{4, 2}, {0, 3}}, {{0, 5.5}, {4, 5}}};
  EXPECT_EQ(windows_of(parts, 4, 0, 2).size(), 1u);
  EXPECT_EQ(windows_of(parts, 4, 0, 1.99).size(), 3u);
}

// Up and down again, or there and back: neither is one passage, though it gets from side to side.
TEST(BoundaryWindows, HoldNoPassageThatTurnsBack) {
  std::vector<BoundaryPart> up_and_down{{{0, 0}, {2, 1}}, {{2, 1}, {4, 0}}};
  EXPECT_FALSE(windows_of(up_and_down, 4, 0, 9).front().passes);
  std::vector<BoundaryPart> there_and_back{{{0, 0}, {3, 1}}, {{3, 1}, {2, 2}}, {{2, 2}, {4, 3}}};
  EXPECT_FALSE(windows_of(there_and_back, 4, 0, 9).front().passes);
  std::vector<BoundaryPart> steps{{{0, 0}, {2, 0}}, {{2, 0}, {2, 3}}, {{2, 3}, {4, 3}}};
  const BoundaryWindow window = windows_of(steps, 4, 0, 9).front();
  EXPECT_TRUE(window.passes);
  EXPECT_TRUE(std::isinf(window.most_slope));
  EXPECT_EQ(window.least_slope, 0);
  // With a margin the passage has to get through that as well.
  EXPECT_FALSE(windows_of(steps, 4, 0.5, 9).front().passes);
}

TEST(BoundaryWindows, OfRandomRegionsShareThePartsAndKnowTheMiddleLine) {
  StripParts cut;
  testing::for_each_seed(80, [&](std::mt19937_64& random, int number) {
    std::uniform_real_distribution<double> width(2, 15), apart(0, 6);
    const Ring ring = testing::random_star(random, {3, -5}, 12, 60, 3 + number % 25);
    const StripGrid grid{TrackFrame(), 0.3, width(random)};
    const double apart_m = apart(random), margin_m = number % 2 == 0 ? 0 : 0.2 * grid.width_m;
    const StripRange range{grid.strip_at(-50), grid.strip_at(50)};
    cut.collect({ring}, grid, range, margin_m);
    for (int k = range.first; k <= range.last; ++k) {
      const auto parts = cut.in(static_cast<std::size_t>(k - range.first));
      std::size_t in_windows = 0;
      double before = -std::numeric_limits<double>::infinity();
      for (const BoundaryWindow& window : windows_of(parts, grid.width_m, margin_m, apart_m)) {
        ASSERT_GT(window.lowest - before, apart_m);
        before = window.highest;
        in_windows += window.parts.size();
        double lowest = 1e9, highest = -1e9;
        for (const BoundaryPart& part : window.parts) {
          lowest = std::min({lowest, part.from.y, part.to.y});
          highest = std::max({highest, part.from.y, part.to.y});
        }
        ASSERT_EQ(window.lowest, lowest);
        ASSERT_EQ(window.highest, highest);
        // Where one window ends and the next begins at once, there is no land between them to look at.
        if (apart_m > 1e-3) {
          ASSERT_EQ(window.inside_after, contains(ring, {grid.centre(k), highest + 1e-4}))
              << "strip " << k << " beyond " << highest;
        }
      }
      ASSERT_EQ(in_windows, parts.size());
    }
  });
}

/// A passage through a strip, from left to right at random heights that rise or fall all the way.
std::vector<BoundaryPart> random_passage(std::mt19937_64& random, double width_m) {
  std::uniform_real_distribution<double> across(0, width_m), step(0, 5);
  std::uniform_int_distribution<int> count(0, 4), coin(0, 1);
  std::vector<double> xs{0, width_m};
  for (int i = count(random); i > 0; --i) xs.push_back(across(random));
  std::sort(xs.begin(), xs.end());
  const double sense = coin(random) == 0 ? 1 : -1;
  std::vector<Point> chain{{0, 0}};
  for (std::size_t i = 1; i < xs.size(); ++i) {
    chain.push_back({xs[i], chain.back().y + sense * step(random)});
    if (coin(random) == 0) chain.push_back({xs[i], chain.back().y + sense * step(random)});
  }
  const bool begins = coin(random) == 0;
  std::vector<BoundaryPart> out;
  for (std::size_t i = 0; i + 1 < chain.size(); ++i)
    out.push_back(begins ? BoundaryPart{chain[i], chain[i + 1]} : BoundaryPart{chain[i + 1], chain[i]});
  return out;
}

/// What an end at y costs, column by column.
double cost_of_end(const BoundaryWindow& window, double y, double over_price, double under_price) {
  constexpr int kColumns = 400;
  double sum = 0;
  for (const BoundaryPart& part : window.parts) {
    const double step = std::abs(part.to.x - part.from.x) / kColumns;
    for (int i = 0; i < kColumns; ++i) {
      const double height = part.from.y + (part.to.y - part.from.y) * (i + 0.5) / kColumns;
      const double outside = window.begins ? height - y : y - height;  // worked beyond the boundary
      sum += step * (outside > 0 ? over_price * outside : -under_price * outside);
    }
  }
  return sum;
}

TEST(BoundaryWindows, APassageCostsWhatTheBestOfAllEndsDoes) {
  testing::for_each_seed(200, [](std::mt19937_64& random, int number) {
    std::uniform_real_distribution<double> price(0, 2), width(1, 12);
    const double width_m = width(random);
    const double over = number % 11 == 0 ? 0 : price(random), under = number % 13 == 0 ? 0 : price(random);
    std::vector<BoundaryPart> parts = random_passage(random, width_m);
    const BoundaryWindow window = windows_of(parts, width_m, 0, 99).front();
    ASSERT_TRUE(window.passes);
    // The cost is convex in y.
    double low = window.lowest, high = window.highest;
    for (int i = 0; i < 60; ++i) {
      const double a = low + (high - low) / 3, b = high - (high - low) / 3;
      if (cost_of_end(window, a, over, under) <= cost_of_end(window, b, over, under))
        high = b;
      else
        low = a;
    }
    const double best = cost_of_end(window, 0.5 * (low + high), over, under);
    ASSERT_NEAR(passage_cost(window, width_m, over, under), best, 1e-3 * (1 + best));
  });
}

// ½·w²·cot φ · λo·λu/(λo + λu): docs/bounds.md for a straight edge, here 2 m a metre across.
TEST(BoundaryWindows, AStraightPassageCostsWhatTheFormulaSays) {
  for (const bool begins : {true, false})
    for (const double sense : {1.0, -1.0}) {
      const Point left{0, 0}, right{3, sense * 6};
      std::vector<BoundaryPart> parts{begins ? BoundaryPart{left, right} : BoundaryPart{right, left}};
      const BoundaryWindow window = windows_of(parts, 3, 0, 0).front();
      EXPECT_NEAR(passage_cost(window, 3, 0.02, 0.1), 0.5 * 9 * 2 * 0.02 * 0.1 / 0.12, 1e-12);
      EXPECT_EQ(passage_cost(window, 3, 0, 0), 0);
    }
}

// The land in the margins is no part of the strip.
TEST(BoundaryWindows, APassageCostsNothingBesideTheStrip) {
  std::vector<BoundaryPart> parts{{{-1, -50}, {0, 0}}, {{0, 0}, {3, 6}}, {{3, 6}, {4, 90}}};
  const BoundaryWindow window = windows_of(parts, 3, 1, 0).front();
  ASSERT_TRUE(window.passes);
  EXPECT_NEAR(passage_cost(window, 3, 0.02, 0.1), 0.5 * 9 * 2 * 0.02 * 0.1 / 0.12, 1e-12);
}

}  // namespace
}  // namespace tramline
