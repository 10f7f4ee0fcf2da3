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

void expect_driven_reach(const SteeredStretch& stretch, Point direction, Point fixed, int number) {
  const double expected = driven_reach({stretch}, direction, fixed);
  const double found = reach({stretch}, direction, fixed);
  // between two of the driven places at most step²/8 times the curvature of the point's way is missed
  EXPECT_GE(found, expected - 1e-9) << number;
  EXPECT_LE(found, expected + 2e-5) << number;
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
    const Point fixed = i % 3 == 0   ? Point{0, 0}
                        : i % 3 == 1 ? Point{0, between(-8, 8)}
                                     : Point{between(-8, 8), between(-8, 8)};
    expect_driven_reach(stretch, turned({1, 0}, between(0, 6.3)), fixed, i);
  }
}

TEST(Reach, PointsNearTheCentreOfATurnMoveToAndFro) {
  // beside the axle by more than √3 of what they are ahead, and near the centre on the way: there the angle
  // of their motion turns quickest
  std::mt19937_64 random(7);
  const auto between = [&](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
  };
  for (int i = 0; i < 600; ++i) {
    const Pose start{{between(-50, 50), between(-50, 50)},
                     Heading::clockwise_from_north(Angle::radians(between(0, 6.3)))};
    const double curvature = between(0.15, 0.4), to_each_side = between(0.02, 0.15);
    const double side = i % 2 == 0 ? 1 : -1;
    const SteeredStretch stretch{start, between(2, 12), side * (curvature - to_each_side),
                                 side * (curvature + to_each_side),
                                 i % 3 == 0 ? Gear::kForward : Gear::kReverse};
    const Point fixed{between(-0.3, 0.3), side / curvature};
    expect_driven_reach(stretch, turned({1, 0}, between(0, 6.3)), fixed, i);
    if (HasFailure()) return;
  }
}

}  // namespace
}  // namespace tramline
