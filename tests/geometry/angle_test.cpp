#include "tramline/geometry/angle.h"

#include <gtest/gtest.h>

#include <type_traits>

namespace tramline {
namespace {

// Mixing an angle with a bare number, or an axis with a heading, must not compile.
static_assert(!std::is_constructible_v<Angle, double>);
static_assert(!std::is_constructible_v<Direction, double>);
static_assert(!std::is_constructible_v<Heading, double>);
static_assert(!std::is_convertible_v<Direction, Heading>);
static_assert(!std::is_convertible_v<Heading, Direction>);

TEST(Direction, IsClockwiseFromNorthModulo180) {
  EXPECT_NEAR(Direction::along({0, 0}, {0, 5}).degrees(), 0, 1e-12);
  EXPECT_NEAR(Direction::along({0, 0}, {5, 0}).degrees(), 90, 1e-12);
  EXPECT_NEAR(Direction::along({5, 0}, {0, 0}).degrees(), 90, 1e-12);
  EXPECT_NEAR(Direction::along({0, 0}, {1, 1}).degrees(), 45, 1e-12);
  EXPECT_NEAR(Direction::along({0, 0}, {-1, 1}).degrees(), 135, 1e-12);
  EXPECT_NEAR(Direction::clockwise_from_north(Angle::degrees(-10)).degrees(), 170, 1e-12);
}

TEST(Direction, NeverReaches180) {
  EXPECT_LT(Direction::clockwise_from_north(Angle::radians(-1e-300)).degrees(), 180);
  EXPECT_EQ(Direction::clockwise_from_north(Angle::radians(-1e-300)).degrees(), 0);
}

TEST(Direction, AnglesBetweenAxesWrap) {
  const auto at = [](double d) { return Direction::clockwise_from_north(Angle::degrees(d)); };
  EXPECT_NEAR(angle_between(at(179), at(1)).degrees(), 2, 1e-12);
  EXPECT_NEAR(angle_between(at(0), at(90)).degrees(), 90, 1e-12);
  EXPECT_NEAR(angle_between(at(10), at(120)).degrees(), 70, 1e-12);
}

TEST(Heading, IsModulo360) {
  EXPECT_NEAR(Heading::from_to({0, 0}, {-1, 0}).degrees(), 270, 1e-12);
  EXPECT_NEAR(Heading::from_to({0, 0}, {-1, 0}).direction().degrees(), 90, 1e-12);
}

}  // namespace
}  // namespace tramline
