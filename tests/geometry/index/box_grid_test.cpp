#include "tramline/geometry/index/box_grid.h"

#include <gtest/gtest.h>

#include "geometry/random_shapes.h"

namespace tramline::box_grid_test {

using testing::RandomCase;

std::vector<std::size_t> visited(const BoxGrid& grid, const Box& window) {
  std::vector<std::size_t> out;
  grid.each_meeting(window, [&](std::size_t i) { out.push_back(i); });
  return out;
}

std::vector<std::size_t> all_that_meet(const std::vector<Box>& boxes, const Box& window) {
  std::vector<std::size_t> out;
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    const bool apart = boxes[i].max_x < window.min_x || boxes[i].min_x > window.max_x ||
                       boxes[i].max_y < window.min_y || boxes[i].min_y > window.max_y;
    if (!apart) out.push_back(i);
  }
  return out;
}

/// Points, lines and boxes, crowded or far apart, in a land that may be flat.
std::vector<Box> random_boxes(RandomCase& random, double width, double height) {
  std::vector<Box> out;
  for (int i = random.whole(1, 60); i > 0; --i) {
    const Point low{random.between(0, width), random.between(0, height)};
    const double longest = random.whole(0, 5) == 0 ? width : 0.1 * width;
    const Point by{random.whole(0, 2) == 0 ? 0 : random.between(0, longest),
                   random.whole(0, 2) == 0 ? 0 : random.between(0, longest)};
    out.push_back(bounds(low, low + by));
  }
  return out;
}

TEST(BoxGrid, VisitsEachBoxThatMeetsTheGivenOneOnce) {
  std::size_t met = 0, missed = 0;
  for (int number = 0; number < 300; ++number) {
    RandomCase random(number);
    const double height = number % 3 == 0 ? 0 : number % 3 == 1 ? 100 : 1;
    const std::vector<Box> boxes = random_boxes(random, 100, height);
    const BoxGrid grid(boxes);
    std::vector<Box> windows = boxes;
    windows.push_back({-1000, -1000, 1000, 1000});
    for (int i = 0; i < 20; ++i) {
      const Point a = random.point_in({-20, -20, 120, 120}), b = random.point_in({-20, -20, 120, 120});
      windows.push_back(bounds(a, random.whole(0, 1) == 0 ? a : b));
    }
    for (const Box& window : windows) {
      std::vector<std::size_t> found = visited(grid, window);
      std::sort(found.begin(), found.end());
      ASSERT_EQ(found, all_that_meet(boxes, window));
      met += found.size();
      missed += boxes.size() - found.size();
    }
  }
  EXPECT_GT(met, 10000U) << "the windows meet too little to tell";
  EXPECT_GT(missed, 10000U) << "the windows leave out too little to tell";
}

// Four cells to the square, each with a corner of it: rows from the south, columns from the west.
TEST(BoxGrid, VisitsByCellAndThenByIndex) {
  const auto at = [](double x, double y) { return bounds({x, y}, {x, y}); };
  const BoxGrid grid({at(10, 10), at(0, 10), at(10, 0), at(0, 0), at(0.1, 0.1)});
  EXPECT_EQ(visited(grid, {0, 0, 10, 10}), (std::vector<std::size_t>{3, 4, 2, 1, 0}));
}

TEST(BoxGrid, CountsBoxesThatOnlyTouch) {
  const BoxGrid grid({{0, 0, 1, 1}, {2, 0, 3, 1}});
  EXPECT_EQ(visited(grid, {1, 1, 2, 2}).size(), 2U);
  EXPECT_TRUE(visited(grid, {1.001, 0, 1.999, 1}).empty());
  EXPECT_TRUE(visited(grid, {0, 1.001, 3, 2}).empty());
}

TEST(BoxGrid, HasAboutOneCellForEachBox) {
  std::vector<Box> boxes;
  for (int x = 0; x < 10; ++x)
    for (int y = 0; y < 40; ++y) boxes.push_back({2. * x, 2. * y, 2. * x + 2, 2. * y + 2});
  const BoxGrid grid(boxes);
  EXPECT_NEAR(grid.cell_m(), 2, 1e-12) << "400 boxes in 20 m by 80 m";
  EXPECT_EQ(grid.bounds().min_x, 0);
  EXPECT_EQ(grid.bounds().min_y, 0);
  EXPECT_EQ(grid.bounds().max_x, 20);
  EXPECT_EQ(grid.bounds().max_y, 80);
}

TEST(BoxGrid, TakesBoxesThatAreAllOnePoint) {
  const std::vector<Box> boxes(50, bounds({3, 4}, {3, 4}));
  const BoxGrid grid(boxes);
  EXPECT_EQ(visited(grid, {3, 4, 3, 4}).size(), 50U);
  EXPECT_TRUE(visited(grid, {3.1, 4, 5, 4}).empty());
}

TEST(BoxGrid, OfNoBoxesVisitsNone) {
  EXPECT_TRUE(visited(BoxGrid(), {-1, -1, 1, 1}).empty());
  EXPECT_TRUE(visited(BoxGrid(std::vector<Box>{}), {-1, -1, 1, 1}).empty());
}

}  // namespace tramline::box_grid_test
