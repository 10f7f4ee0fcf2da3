#include "tramline/geometry/polygon/outline_distance.h"

#include <gtest/gtest.h>

#include <cmath>

namespace tramline {
namespace {

const Ring kSquare{{0, 0}, {10, 0}, {10, 10}, {0, 10}};

TEST(OutlineDistance, IsToTheNearestEdgeOnEitherSide) {
  EXPECT_DOUBLE_EQ(distance_to_outline({4, 3}, kSquare), 3) << "inside";
  EXPECT_DOUBLE_EQ(distance_to_outline({12, 5}, kSquare), 2) << "outside";
  EXPECT_DOUBLE_EQ(distance_to_outline({-2, 6}, kSquare), 2) << "beside the edge that closes the ring";
  EXPECT_DOUBLE_EQ(distance_to_outline({13, 14}, kSquare), 5) << "to a corner";
  EXPECT_DOUBLE_EQ(distance_to_outline({10, 7}, kSquare), 0);
  EXPECT_TRUE(std::isinf(distance_to_outline({0, 0}, Ring{})));
}

TEST(OutlineDistance, CountsHolesAmongTheEdges) {
  const Polygon with_hole{kSquare, {{{4, 4}, {4, 6}, {6, 6}, {6, 4}}}};
  EXPECT_DOUBLE_EQ(distance_to_outline({5, 5}, with_hole), 1) << "in the hole";
  EXPECT_DOUBLE_EQ(distance_to_outline({5, 3.5}, with_hole), 0.5) << "nearer to the hole than to the outline";
  EXPECT_DOUBLE_EQ(distance_to_outline({5, 1}, with_hole), 1) << "nearer to the outline";
}

}  // namespace
}  // namespace tramline
