// Passages and their wedges against polygon booleans.

#include "tramline/cost/grid/row_end_wedges.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "properties/seeds.h"
#include "tramline/geometry/polygon/boolean.h"

namespace tramline {
namespace {

Region box_region(double min_x, double min_y, double max_x, double max_y) {
  return {{{{min_x, min_y}, {max_x, min_y}, {max_x, max_y}, {min_x, max_y}}, {}}};
}

/// A field from a lower chain to an upper one, both from left to right.
struct TwoChains {
  std::vector<Point> lower, upper;
  Ring ring() const {
    Ring out = lower;
    out.insert(out.end(), upper.rbegin(), upper.rend());
    return out;
  }
};

double height_at(const std::vector<Point>& chain, double x) {
  std::size_t i = 1;
  while (i + 1 < chain.size() && chain[i].x < x) ++i;
  const Point a = chain[i - 1], b = chain[i];
  return a.y + (b.y - a.y) * (x - a.x) / (b.x - a.x);
}

/// The heights of a chain between two coordinates across, in order.
std::vector<double> heights(const std::vector<Point>& chain, double left, double right) {
  std::vector<double> out{height_at(chain, left)};
  for (const Point p : chain)
    if (left < p.x && p.x < right) out.push_back(p.y);
  out.push_back(height_at(chain, right));
  return out;
}

bool monotone(const std::vector<double>& values) {
  return std::is_sorted(values.begin(), values.end()) || std::is_sorted(values.rbegin(), values.rend());
}

TwoChains random_chains(std::mt19937_64& random) {
  std::uniform_real_distribution<double> across(0.01, 59.9), low(0, 13), high(15, 40);
  std::uniform_int_distribution<int> corners(0, 8);
  const auto chain = [&](std::uniform_real_distribution<double>& height) {
    std::vector<double> xs{0, 60};
    for (int i = corners(random); i > 0; --i) xs.push_back(across(random));
    std::sort(xs.begin(), xs.end());
    std::vector<Point> out;
    for (const double x : xs) out.push_back({x, height(random)});
    return out;
  };
  return {chain(low), chain(high)};
}

void expect_wedge(const RowEndWedge& wedge, const Region& field, const StripGrid& grid, int strip,
                  const EndCriterion& criterion) {
  const double left = grid.line(strip), right = grid.line(strip + 1);
  const Region swath =
      wedge.begins ? box_region(left, wedge.at, right, 14) : box_region(left, 14, right, wedge.at);
  // Only what lies beyond the passage: the other end's land is cut off at y = 14.
  ASSERT_NEAR(wedge.over_m2, area(swath) - area(intersection(swath, field)), 1e-3);
  const Point middle{grid.centre(strip), wedge.at};
  if (criterion.by_centre_line) {
    ASSERT_NE(contains(field, middle + Point{0, 1e-6}), contains(field, middle - Point{0, 1e-6}));
    return;
  }
  ASSERT_NEAR(length_inside(field, {left, wedge.at}, {right, wedge.at}), criterion.least_width_m, 1e-6);
}

// The ends of every strip that both chains pass without turning back; in all others nothing is claimed.
TEST(RowEndWedges, WorkInVainWhatBooleansSay) {
  RowEndWedges wedges;
  int plain = 0, intricate = 0;
  testing::for_each_seed(150, [&](std::mt19937_64& random, int number) {
    const TwoChains field = random_chains(random);
    std::uniform_real_distribution<double> width(3, 15), share(0.05, 0.95), off(0, 3);
    const StripGrid grid{TrackFrame(), -off(random), width(random)};
    const EndCriterion criterion{number % 3 == 0, share(random) * grid.width_m};
    const Region region{{field.ring(), {}}};
    const StripRange range{grid.strip_at(0.0) + 1, grid.strip_at(60) - 1};
    wedges.collect({field.ring()}, grid, range, criterion);
    for (int k = range.first; k <= range.last; ++k) {
      const auto found = wedges.in_strip(static_cast<std::size_t>(k - range.first));
      const std::vector<double> low = heights(field.lower, grid.line(k), grid.line(k + 1)),
                                high = heights(field.upper, grid.line(k), grid.line(k + 1));
      ASSERT_EQ(found.plain, monotone(low) && monotone(high)) << "strip " << k;
      ++(found.plain ? plain : intricate);
      if (!found.plain) continue;
      ASSERT_EQ(found.end - found.begin, 2);
      ASSERT_TRUE(found.begin[0].begins);
      ASSERT_FALSE(found.begin[1].begins);
      ASSERT_NEAR(found.begin[0].lowest, *std::min_element(low.begin(), low.end()), 1e-9);
      ASSERT_NEAR(found.begin[0].highest, *std::max_element(low.begin(), low.end()), 1e-9);
      ASSERT_NEAR(found.begin[1].lowest, *std::min_element(high.begin(), high.end()), 1e-9);
      ASSERT_NEAR(found.begin[1].highest, *std::max_element(high.begin(), high.end()), 1e-9);
      for (const RowEndWedge* wedge : {found.begin, found.begin + 1})
        expect_wedge(*wedge, region, grid, k, criterion);
      if (::testing::Test::HasFatalFailure()) return;
    }
  });
  if (testing::case_count(150) >= 150) {
    EXPECT_GT(plain, 200);
    EXPECT_GT(intricate, 100);
  }
}

// Versleijen's wedge: a straight edge at φ to the strip, run over until a share f of the width is outside,
// leaves ½·f²·w²·cot φ in vain. Here w = 2 and cot φ = 3.
TEST(RowEndWedges, OfAStraightEdgeAreThoseOfTheFormula) {
  const StripGrid grid{TrackFrame(), -1, 2};
  RowEndWedges wedges;
  for (const double outside : {0.25, 0.5, 0.8})
    for (const double sense : {1.0, -1.0}) {
      const double tilt = sense * 3 * 10;
      wedges.collect({{{0, 0}, {10, 0}, {10, 100 + tilt}, {0, 100}}}, grid, {1, 3},
                     {false, 2 * (1 - outside)});
      for (std::size_t i = 0; i < 3; ++i) {
        const auto found = wedges.in_strip(i);
        ASSERT_TRUE(found.plain);
        ASSERT_EQ(found.end - found.begin, 2);
        EXPECT_NEAR(found.begin[0].over_m2, 0, 1e-9) << "the lower side is square to the strips";
        EXPECT_NEAR(found.begin[1].over_m2, 0.5 * outside * outside * 4 * 3, 1e-9);
        const double lower_end = 100 + sense * 3 * grid.line(static_cast<int>(i) + (sense > 0 ? 1 : 2));
        EXPECT_NEAR(found.begin[1].at, lower_end + outside * 2 * 3, 1e-9);
      }
    }
}

// A hole that a strip passes cuts it in two: begin, end, begin, end.
TEST(RowEndWedges, OfAHoleBoundTwoPieces) {
  const StripGrid grid{TrackFrame(), -1, 2};
  RowEndWedges wedges;
  wedges.collect({{{0, 0}, {20, 0}, {20, 50}, {0, 50}}, {{2, 20}, {2, 30}, {9, 30}, {9, 20}}}, grid, {0, 9},
                 {false, 1});
  const auto through = wedges.in_strip(3);  // from x = 5 to x = 7
  ASSERT_TRUE(through.plain);
  ASSERT_EQ(through.end - through.begin, 4);
  const double at[] = {0, 20, 30, 50};
  for (int i = 0; i < 4; ++i) {
    EXPECT_EQ(through.begin[i].begins, i % 2 == 0);
    EXPECT_NEAR(through.begin[i].at, at[i], 1e-12);
    EXPECT_EQ(through.begin[i].over_m2, 0);
  }
  // The hole's left side stands in strip 1 (x from 1 to 3), the field's own in strip 0.
  EXPECT_FALSE(wedges.in_strip(1).plain);
  EXPECT_FALSE(wedges.in_strip(0).plain);
  ASSERT_TRUE(wedges.in_strip(7).plain) << "beside the hole";
  EXPECT_EQ(wedges.in_strip(7).end - wedges.in_strip(7).begin, 2);
}

TEST(RowEndWedges, AreNotClaimedWhereARingLiesWithinOneStrip) {
  const StripGrid grid{TrackFrame(), 0, 10};
  RowEndWedges wedges;
  wedges.collect({{{-5, 0}, {25, 0}, {25, 50}, {-5, 50}}, {{4, 20}, {4, 30}, {6, 30}, {6, 20}}}, grid, {0, 1},
                 {false, 5});
  EXPECT_FALSE(wedges.in_strip(0).plain);
  EXPECT_TRUE(wedges.in_strip(1).plain);
}

}  // namespace
}  // namespace tramline
