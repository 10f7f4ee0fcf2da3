#include "tramline/geometry/strip/strip_grid.h"

#include <gtest/gtest.h>

#include "geometry/random_shapes.h"

namespace tramline::strip_grid_test {

using testing::RandomCase;

StripGrid strip_grid(double origin, double width) { return {TrackFrame(), origin, width}; }

std::vector<int> strips_in(const StripRange& range) {
  std::vector<int> out;
  for (int k = range.first; k <= range.last; ++k) out.push_back(k);
  EXPECT_EQ(range.size(), static_cast<int>(out.size()));
  return out;
}

TEST(StripGrid, CountsFromItsOrigin) {
  const StripGrid grid = strip_grid(10, 3);
  EXPECT_EQ(grid.line(0), 10);
  EXPECT_EQ(grid.line(-2), 4);
  EXPECT_EQ(grid.centre(2), 17.5);
  EXPECT_EQ(grid.strip_at(10), 0);
  EXPECT_EQ(grid.strip_at(12.999), 0);
  EXPECT_EQ(grid.strip_at(13), 1);
  EXPECT_EQ(grid.strip_at(9.999), -1);
  EXPECT_EQ(grid.strip_at(7), -1);
  EXPECT_EQ(grid.strip_at(6.999), -2);
}

// A line belongs to the strip that begins there, and the number before it to the one that ends, however the
// division rounds.
TEST(StripGrid, OwnsItsFirstLineToTheLastDigit) {
  for (int number = 0; number < 200; ++number) {
    RandomCase random(number);
    const StripGrid grid =
        strip_grid(random.between(-1e5, 1e5), number % 2 == 0 ? random.between(0.3, 40) : 0.1);
    for (int i = 0; i < 100; ++i) {
      const int k = random.whole(-5000, 5000);
      ASSERT_EQ(grid.strip_at(grid.line(k)), k);
      ASSERT_EQ(grid.strip_at(std::nextafter(grid.line(k), -1e9)), k - 1);
      ASSERT_EQ(grid.strip_at(grid.centre(k)), k);
    }
  }
}

TEST(StripsOver, AreThoseThatTheBoxReachesInto) {
  const StripGrid grid = strip_grid(0, 3);
  EXPECT_EQ(strips_in(strips_over(grid, {0, 0, 9, 50}, 0.01)), (std::vector<int>{0, 1, 2}));
  EXPECT_EQ(strips_in(strips_over(grid, {-0.02, 0, 9.02, 50}, 0.01)), (std::vector<int>{-1, 0, 1, 2, 3}));
  EXPECT_EQ(strips_in(strips_over(grid, {-0.005, 0, 9.005, 50}, 0.01)), (std::vector<int>{0, 1, 2}));
  EXPECT_EQ(strips_in(strips_over(grid, {4, 0, 5, 50}, 0.01)), (std::vector<int>{1}));
}

TEST(StripsOver, AreNoneOfNothing) {
  const StripGrid grid = strip_grid(0, 3);
  EXPECT_EQ(strips_over(grid, Box{}, 0.01).size(), 0);
  EXPECT_EQ(strips_over(grid, {4, 0, 4.01, 50}, 0.01).size(), 0);
  EXPECT_EQ(StripRange().size(), 0);
  EXPECT_EQ((StripRange{3, 1}.size()), 0);
  EXPECT_EQ((StripRange{3, 3}.size()), 1);
}

TEST(StripsOver, OverlapTheBoxByMoreThanTheSlack) {
  for (int number = 0; number < 500; ++number) {
    RandomCase random(number);
    const StripGrid grid = strip_grid(random.between(-5, 5), random.between(1, 5));
    const double slack = random.between(0.01, 0.4);
    const Box box = bounds(random.point_in({-30, 0, 30, 9}), random.point_in({-30, 0, 30, 9}));
    if (box.width() <= 2 * slack) continue;
    std::vector<int> expected;
    for (int k = -60; k <= 60; ++k)
      if (std::min(box.max_x, grid.line(k + 1)) - std::max(box.min_x, grid.line(k)) > slack)
        expected.push_back(k);
    EXPECT_EQ(strips_in(strips_over(grid, box, slack)), expected);
  }
}

}  // namespace tramline::strip_grid_test
