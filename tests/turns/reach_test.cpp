// How far a machine gets to a side: by hand, and against many places of paths driven in small steps.

#include "tramline/turns/manoeuvres/reach.h"

#include <gtest/gtest.h>

#include <numbers>
#include <random>

#include "turns/integration.h"

namespace tramline {
namespace {

const Heading kReachNorth = Heading::clockwise_from_north(Angle::degrees(0));
constexpr double kReachPi = std::numbers::pi;

TEST(Reach, AHalfCircleReachesItsRadiusAndItsDiameter) {
  const SteeredPath right = {arc_from({{10, 20}, kReachNorth}, 6 * kReachPi, -1.0 / 6, Gear::kForward)};
  EXPECT_NEAR(reach(right, {0, 1}), 6, 1e-12);
  EXPECT_NEAR(reach(right, {1, 0}), 12, 1e-12);
  EXPECT_NEAR(reach(right, {-1, 0}), 0, 1e-12);
  EXPECT_NEAR(reach(right, {0, -1}), 0, 1e-12);
}

TEST(Reach, ACornerRunsOnACircleAboutTheSameCentre) {
  const SteeredPath right = {arc_from({{10, 20}, kReachNorth}, 6 * kReachPi, -1.0 / 6, Gear::kForward)};
  // 2 m ahead and 3 m left: 9 m beside the centre, which is 6 m to the right of the start
  EXPECT_NEAR(reach(right, {0, 1}, {2, 3}), std::hypot(2, 9), 1e-12);
  EXPECT_NEAR(reach(right, {1, 0}, {2, 3}), 6 + std::hypot(2, 9), 1e-12);
  // towards the west it starts at 3 m and is farthest 9.22 m from the centre only before the start
  EXPECT_NEAR(reach(right, {-1, 0}, {2, 3}), 3, 1e-12);
  // a point behind stays behind
  EXPECT_NEAR(reach({arc_from({{0, 0}, kReachNorth}, 1, 0, Gear::kForward)}, {0, 1}, {-4, 0}), -3, 1e-12);
}

TEST(Reach, ReverseIsDrivenAlongTheSameCircle) {
  const SteeredPath back = {arc_from({{0, 0}, kReachNorth}, 6 * kReachPi, 1.0 / 6, Gear::kReverse)};
  EXPECT_NEAR(reach(back, {0, -1}), 6, 1e-12);
  EXPECT_NEAR(reach(back, {-1, 0}), 12, 1e-12);
}

TEST(Reach, APathWithoutStretchesGoesNowhere) { EXPECT_EQ(reach({}, {0, 1}), 0); }

double driven_reach(const SteeredPath& path, Point direction, Point fixed) {
  double most = -1e9;
  for (const testing::DrivenPose& pose : testing::driven(path.front().start, path, 20000)) {
    const Point unit{std::cos(pose.angle), std::sin(pose.angle)};
    const Point at = Point{pose.x, pose.y} + fixed.x * unit + fixed.y * left_of(unit);
    most = std::max(most, dot(at - path.front().start.at, direction));
  }
  return most;
}

TEST(Reach, IsThatOfManyPlacesOnArcsAndClothoids) {
  std::mt19937_64 random(1);
  const auto between = [&](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
  };
  for (int i = 0; i < 300; ++i) {
    const Pose start{{between(-50, 50), between(-50, 50)},
                     Heading::clockwise_from_north(Angle::radians(between(0, 6.3)))};
    SteeredStretch stretch{start, between(0.5, 40), between(-0.3, 0.3), between(-0.3, 0.3),
                           i % 2 == 0 ? Gear::kForward : Gear::kReverse};
    if (i % 5 == 0) stretch.curvature_at_end = stretch.curvature_at_start;
    const Point direction = turned({1, 0}, between(0, 6.3));
    const Point fixed = i % 3 == 0   ? Point{0, 0}
                        : i % 3 == 1 ? Point{0, between(-8, 8)}
                                     : Point{between(-8, 8), between(-8, 8)};
    const double expected = driven_reach({stretch}, direction, fixed);
    const double found = reach({stretch}, direction, fixed);
    // between two of the driven places at most step²/8 times the curvature of the point's way is missed
    EXPECT_GE(found, expected - 1e-9) << i;
    EXPECT_LE(found, expected + 2e-5) << i;
  }
}

}  // namespace
}  // namespace tramline
