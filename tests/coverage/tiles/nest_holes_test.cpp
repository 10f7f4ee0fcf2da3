// Which ground a hole is a hole of, however its ring begins.

#include "tramline/coverage/tiles/nest_holes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

namespace tramline::coverage {
namespace {

GridRing grid_box(std::int64_t west, std::int64_t south, std::int64_t east, std::int64_t north) {
  return {{west, south}, {east, south}, {east, north}, {west, north}};
}

GridRing clockwise(GridRing ring) {
  std::reverse(ring.begin(), ring.end());
  return ring;
}

/// The same for every corner that the rings may begin with.
void expect_parents(std::vector<GridRing> holes, const std::vector<GridRing>& outer,
                    const std::vector<std::size_t>& expected) {
  std::size_t corners = 0;
  for (const GridRing& hole : holes) corners = std::max(corners, hole.size());
  for (std::size_t turn = 0; turn < corners; ++turn) {
    for (GridRing& hole : holes) std::rotate(hole.begin(), hole.begin() + 1, hole.end());
    EXPECT_EQ(parents_of(holes, outer), expected) << "turned by " << turn;
  }
}

TEST(NestHoles, NextToOneAnother) {
  expect_parents({clockwise(grid_box(10, 10, 20, 20)), clockwise(grid_box(30, 12, 40, 22)),
                  clockwise(grid_box(210, 10, 220, 20))},
                 {grid_box(0, 0, 100, 100), grid_box(200, 0, 300, 100)}, {0, 0, 1});
}

// An island in a lake has a pond.
TEST(NestHoles, WithinOneAnother) {
  expect_parents({clockwise(grid_box(10, 10, 90, 90)), clockwise(grid_box(40, 40, 50, 50))},
                 {grid_box(0, 0, 100, 100), grid_box(20, 20, 80, 80)}, {0, 1});
}

// A stands in the cup of B, whose western wall is west of A, as A is of the eastern one.
TEST(NestHoles, HookedIntoOneAnother) {
  const GridRing a = clockwise({{20, 20}, {30, 20}, {30, 110}, {90, 110}, {90, 120}, {20, 120}, {20, 25}});
  const GridRing b =
      clockwise({{10, 5}, {90, 5}, {90, 80}, {80, 80}, {80, 15}, {15, 15}, {15, 30}, {10, 30}});
  expect_parents({a, b}, {grid_box(0, 0, 200, 200)}, {0, 0});
  expect_parents({b, a}, {grid_box(0, 0, 200, 200)}, {0, 0});
}

TEST(NestHoles, TouchingOneAnother) {
  const GridRing diamond = clockwise({{50, 40}, {60, 50}, {50, 60}, {40, 50}});
  // At the western corner, the southern, the eastern; above and below on one upright line.
  expect_parents({diamond, clockwise({{40, 50}, {30, 60}, {30, 40}})}, {grid_box(0, 0, 200, 200)}, {0, 0});
  expect_parents({diamond, clockwise({{40, 50}, {35, 70}, {30, 70}})}, {grid_box(0, 0, 200, 200)}, {0, 0});
  expect_parents({diamond, clockwise({{40, 50}, {41, 90}, {38, 90}})}, {grid_box(0, 0, 200, 200)}, {0, 0});
  expect_parents({diamond, clockwise({{50, 40}, {45, 30}, {55, 30}})}, {grid_box(0, 0, 200, 200)}, {0, 0});
  expect_parents({diamond, clockwise({{60, 50}, {70, 40}, {70, 60}})}, {grid_box(0, 0, 200, 200)}, {0, 0});
  expect_parents({clockwise(grid_box(40, 40, 50, 50)), clockwise({{40, 50}, {45, 60}, {40, 60}})},
                 {grid_box(0, 0, 200, 200)}, {0, 0});
}

// An island touches the shore of the lake it lies in, at the corner furthest west; so does the lake the outer
// ring.
TEST(NestHoles, TouchingAShore) {
  const GridRing lake = clockwise({{10, 50}, {50, 10}, {90, 50}, {50, 90}});
  const GridRing island{{10, 50}, {30, 45}, {30, 55}};
  expect_parents({lake}, {grid_box(0, 0, 100, 100), island}, {0});
  expect_parents({lake}, {island, grid_box(0, 0, 100, 100)}, {1});
  expect_parents({lake}, {grid_box(10, 0, 100, 100)}, {0});
}

TEST(NestHoles, OfNothing) { expect_parents({clockwise(grid_box(10, 10, 20, 20))}, {}, {0}); }

}  // namespace
}  // namespace tramline::coverage
