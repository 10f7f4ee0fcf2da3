#include "tramline/geometry/strip/strip_fold.h"

#include <gtest/gtest.h>

#include "geometry/random_shapes.h"
#include "support/box_ring.h"
#include "tramline/geometry/polygon/boolean.h"

namespace tramline::strip_fold_test {

using testing::RandomCase;

StripGrid upright(double origin, double width) { return {TrackFrame(), origin, width}; }

using testing_support::box;

double inside_at(const StripProfile& profile, double along) {
  for (const Slab& slab : profile.slabs)
    if (slab.from <= along && along <= slab.to) return slab.width_at(along);
  return 0;
}

double area_of(const StripProfile& profile) {
  double sum = 0;
  for (const Slab& slab : profile.slabs)
    sum += 0.5 * (slab.width_from + slab.width_to) * (slab.to - slab.from);
  return sum;
}

void expect_same(const StripProfile& a, const StripProfile& b) {
  ASSERT_EQ(a.slabs.size(), b.slabs.size());
  for (std::size_t i = 0; i < a.slabs.size(); ++i) {
    EXPECT_EQ(a.slabs[i].from, b.slabs[i].from);
    EXPECT_EQ(a.slabs[i].to, b.slabs[i].to);
    EXPECT_EQ(a.slabs[i].width_from, b.slabs[i].width_from);
    EXPECT_EQ(a.slabs[i].width_to, b.slabs[i].width_to);
  }
  EXPECT_EQ(a.centre_line, b.centre_line);
}

TEST(ByStrip, KeepsTheOrderWithinAStrip) {
  ByStrip<int> items;
  for (int round = 0; round < 2; ++round) {
    items.clear(4);
    for (const auto& [strip, item] : {std::pair{2, 5}, {0, 7}, {2, 1}, {3, 4}, {0, 6}, {2, 9}})
      items.add(static_cast<std::size_t>(strip), item);
    items.sort_in();
    const auto in = [&](std::size_t strip) {
      const auto found = items.in(strip);
      return std::vector<int>(found.begin(), found.end());
    };
    EXPECT_EQ(in(0), (std::vector<int>{7, 6}));
    EXPECT_EQ(in(1), std::vector<int>{});
    EXPECT_EQ(in(2), (std::vector<int>{5, 1, 9}));
    EXPECT_EQ(in(3), (std::vector<int>{4}));
  }
}

// From x = 1 to 7 in strips 3 m wide: 2 m of the first, all of the second, 1 m of the third. The centre lines
// are at 1.5, 4.5 and 7.5.
TEST(StripFold, CutsARectangleAtTheLines) {
  StripFold fold;
  fold.fold(std::vector<Ring>{box(1, 2, 7, 12)}, upright(0, 3), {-1, 3}, {});
  const double widths[] = {0, 2, 3, 1, 0};
  for (std::size_t i = 0; i < 5; ++i) {
    const StripProfile& profile = fold.profile(i);
    EXPECT_EQ(profile.empty(), widths[i] == 0) << i;
    EXPECT_NEAR(area_of(profile), 10 * widths[i], 1e-9) << i;
    EXPECT_NEAR(inside_at(profile, 7), widths[i], 1e-9) << i;
    EXPECT_EQ(profile.centre_line, widths[i] > 1.5 ? (Intervals{{2, 12}}) : Intervals{}) << i;
    if (widths[i] == 0) continue;
    EXPECT_EQ(profile.slabs.front().from, 2) << i;
    EXPECT_EQ(profile.slabs.back().to, 12) << i;
  }
}

TEST(StripFold, SeesNothingOfStripsOutsideTheRange) {
  StripFold fold;
  fold.fold(std::vector<Ring>{box(-50, 2, 50, 12)}, upright(0, 3), {2, 3}, {});
  EXPECT_NEAR(area_of(fold.profile(0)), 30, 1e-9);
  EXPECT_NEAR(area_of(fold.profile(1)), 30, 1e-9);
}

TEST(StripFold, LeavesStripsEmptyThatAreNotWanted) {
  StripFold fold;
  fold.fold(std::vector<Ring>{box(0, 0, 12, 5)}, upright(0, 3), {0, 3}, {false, true, false, true});
  for (const std::size_t i : {0U, 2U}) {
    EXPECT_TRUE(fold.profile(i).empty()) << i;
    EXPECT_TRUE(fold.profile(i).centre_line.empty()) << i;
  }
  for (const std::size_t i : {1U, 3U}) EXPECT_NEAR(area_of(fold.profile(i)), 15, 1e-9) << i;
}

// What polygon booleans say of each strip, and of random cross-sections of it.
TEST(StripFold, HoldsTheLandOfEachStrip) {
  int across_an_edge = 0;
  for (int number = 0; number < 100; ++number) {
    RandomCase random(number);
    const Region region = testing::random_region(random);
    const StripGrid grid = upright(random.between(-5, 5), random.between(2, 15));
    const StripRange range{grid.strip_at(-60), grid.strip_at(140)};
    StripFold fold;
    fold.fold(rings_of(region), grid, range, {});
    for (int k = range.first; k <= range.last; ++k) {
      const StripProfile& profile = fold.profile(static_cast<std::size_t>(k - range.first));
      const double left = grid.line(k), right = grid.line(k + 1);
      EXPECT_NEAR(area_of(profile), area(intersection(region, {{box(left, -99, right, 99), {}}})), 1e-3) << k;
      for (std::size_t i = 1; i < profile.slabs.size(); ++i)
        ASSERT_LE(profile.slabs[i - 1].to, profile.slabs[i].from);
      const double along = random.between(-60, 60);
      const double inside = length_inside(region, {left, along}, {right, along});
      EXPECT_NEAR(inside_at(profile, along), inside, 1e-6) << k << " at " << along;
      across_an_edge += inside > 0 && inside < 0.999 * grid.width_m;
      double centre_line = 0;
      for (const Interval& part : profile.centre_line) {
        EXPECT_TRUE(contains(region, {grid.centre(k), 0.5 * (part.from + part.to)})) << k;
        centre_line += part.length();
      }
      EXPECT_NEAR(centre_line, length_inside(region, {grid.centre(k), -99}, {grid.centre(k), 99}), 1e-6) << k;
    }
  }
  EXPECT_GT(across_an_edge, 100);
}

TEST(StripFold, TakesRegionsAndRingsAlikeAndForgetsTheFoldBefore) {
  StripFold kept;
  for (int number = 0; number < 30; ++number) {
    RandomCase random(number);
    const Region region = testing::random_region(random);
    const StripGrid grid = upright(random.between(-5, 5), random.between(2, 15));
    const StripRange range{random.whole(-9, 0), random.whole(0, 9)};
    StripFold fresh;
    fresh.fold(rings_of(region), grid, range, {});
    kept.fold(region, grid, range, {});
    double whole = 0;
    for (int i = 0; i < range.size(); ++i) {
      const StripProfile expected = fresh.profile(static_cast<std::size_t>(i));
      expect_same(kept.profile(static_cast<std::size_t>(i)), expected);
      whole += area_of(expected);
    }
    EXPECT_GT(whole, 0);
  }
}

}  // namespace tramline::strip_fold_test
