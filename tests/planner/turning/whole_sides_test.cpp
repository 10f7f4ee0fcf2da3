// Passes along whole sides of a field, however many corners were recorded along them.

#include "tramline/planner/headland_choice/whole_sides.h"

#include <gtest/gtest.h>

#include <vector>

namespace tramline {
namespace {

constexpr double kWidth_m = 6;

std::vector<int> along_sides(const Ring& outer, std::vector<int> passes) {
  take_whole_sides(outer, kWidth_m, passes);
  return passes;
}

TEST(WholeSides, HaveAsManyPassesAsAnyOfTheirEdges) {
  const Ring outer{{0, 0}, {30, 0}, {60, 0}, {100, 0}, {100, 80}, {50, 80}, {0, 80}};
  EXPECT_EQ(along_sides(outer, {0, 2, 1, 0, 0, 3, 0}), (std::vector<int>{2, 2, 2, 0, 3, 3, 0}));
}

TEST(WholeSides, GoOnPastTheFirstCornerOfTheRing) {
  const Ring outer{{50, 0}, {100, 0}, {100, 80}, {0, 80}, {0, 0}};
  EXPECT_EQ(along_sides(outer, {0, 1, 0, 0, 2}), (std::vector<int>{2, 1, 0, 0, 2}));
}

// A quarter of the width is as straight as a side has to be: 1.4 m of 1.5 m, but not 1.6 m.
TEST(WholeSides, EndWhereTheyBend) {
  const Ring slight{{0, 0}, {50, -1.4}, {100, 0}, {100, 80}, {0, 80}};
  EXPECT_EQ(along_sides(slight, {2, 0, 0, 0, 0}), (std::vector<int>{2, 2, 0, 0, 0}));
  const Ring bent{{0, 0}, {50, -1.6}, {100, 0}, {100, 80}, {0, 80}};
  EXPECT_EQ(along_sides(bent, {2, 0, 0, 0, 0}), (std::vector<int>{2, 0, 0, 0, 0}));
}

}  // namespace
}  // namespace tramline
