#include "tramline/geometry/path/shifted_path.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace tramline {
namespace {

// 10 m east, a quarter circle of radius 20 m to the left, 10 m north; 5 m to the right the arc has 25 m.
TEST(Shifted, LinesMoveAndArcsChangeTheirRadius) {
  const Path path{{{0, 0}, {10, 0}, 0}, {{10, 0}, {30, 20}, 1.0 / 20}, {{30, 20}, {30, 30}, 0}};
  const auto right = shifted(path, 5, 6);
  ASSERT_TRUE(right);
  EXPECT_EQ(right->front().from, (Point{0, -5}));
  EXPECT_NEAR(distance(right->back().to, {35, 30}), 0, 1e-12);
  EXPECT_NEAR(length(*right), 20 + 0.5 * std::numbers::pi * 25, 1e-9);
  const auto left = shifted(path, -10, 6);
  ASSERT_TRUE(left);
  EXPECT_NEAR(length(*left), 20 + 0.5 * std::numbers::pi * 10, 1e-9);
  EXPECT_FALSE(shifted(path, -15, 6));
}

// As tight as it may be, and moved nowhere: 1/(1/r) need not be r.
TEST(Shifted, NothingMovesNothing) {
  for (const double radius : {6.0, 3.7, 11.3, 1e3 / 7}) {
    const Path path{{{0, 0}, {radius, radius}, 1 / radius}};
    ASSERT_TRUE(shifted(path, 0, radius)) << radius;
  }
}

}  // namespace
}  // namespace tramline
