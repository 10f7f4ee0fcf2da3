// Paths of a machine that steers and changes gear: ends by hand and driven in small steps, and the paths made
// from others.

#include "tramline/geometry/path/steered_path.h"

#include <gtest/gtest.h>

#include <numbers>

#include "turns/integration.h"

namespace tramline {
namespace {

Pose north(double x, double y) { return {{x, y}, Heading::clockwise_from_north(Angle::degrees(0))}; }

void expect_pose(const Pose& pose, double x, double y, double degrees) {
  EXPECT_NEAR(pose.at.x, x, 1e-12);
  EXPECT_NEAR(pose.at.y, y, 1e-12);
  EXPECT_NEAR(std::remainder(pose.heading.degrees() - degrees, 360), 0, 1e-10);
}

/// A line, an arc to the left, a clothoid from there to the right, and a way back on an arc.
SteeredPath mixed_path() {
  SteeredPath path = {arc_from(north(3, 4), 5, 0, Gear::kForward)};
  path.push_back(arc_from(end_of(path.back()), 9, 1.0 / 6, Gear::kForward));
  path.push_back({end_of(path.back()), 7, 1.0 / 6, -1.0 / 8, Gear::kForward});
  path.push_back(arc_from(end_of(path.back()), 4, -1.0 / 8, Gear::kReverse));
  return path;
}

TEST(SteeredPath, QuarterCirclesInBothGears) {
  const double quarter = 3 * std::numbers::pi;
  expect_pose(end_of(arc_from(north(0, 0), quarter, 1.0 / 6, Gear::kForward)), -6, 6, 270);
  expect_pose(end_of(arc_from(north(0, 0), quarter, -1.0 / 6, Gear::kForward)), 6, 6, 90);
  // in reverse the centre stays on the left, and the machine swings the other way
  expect_pose(end_of(arc_from(north(0, 0), quarter, 1.0 / 6, Gear::kReverse)), -6, -6, 90);
  expect_pose(end_of(arc_from(north(0, 0), 5, 0, Gear::kReverse)), 0, -5, 0);
}

TEST(SteeredPath, EndsWhereSmallStepsLead) {
  const SteeredPath path = mixed_path();
  EXPECT_EQ(length(path), 25);
  EXPECT_EQ(gear_changes(path), 1);
  EXPECT_LE(testing::difference(testing::driven(path.front().start, path, 2000).back(), end_of(path.back())),
            1e-11);
  const SteeredStretch long_clothoid{north(0, 0), 80, -0.3, 0.5, Gear::kReverse};
  EXPECT_LE(
      testing::difference(testing::driven(north(0, 0), {long_clothoid}, 20000).back(), end_of(long_clothoid)),
      1e-10);
}

TEST(SteeredPath, RetracedLeadsBackWithTheMachineAsItWas) {
  const SteeredPath path = mixed_path(), back = retraced(path);
  EXPECT_EQ(back.front().gear, Gear::kForward);
  EXPECT_LE(testing::difference(testing::driven(end_of(path.back()), back, 2000).back(), path.front().start),
            1e-10);
}

TEST(SteeredPath, TurnedRoundLeadsBackWithTheMachineAboutFace) {
  const SteeredPath path = mixed_path(), round = turned_round(path);
  EXPECT_EQ(round.front().gear, Gear::kReverse);
  const auto about = [](const Pose& pose) {
    return Pose{pose.at, Heading::clockwise_from_north(pose.heading.angle() + Angle::degrees(180))};
  };
  EXPECT_LE(testing::difference(testing::driven(about(end_of(path.back())), round, 2000).back(),
                                about(path.front().start)),
            1e-10);
}

TEST(SteeredPath, TheMirrorImageTurnsToTheOtherSide) {
  const SteeredPath path = mixed_path(), image = mirrored(path, north(10, 0));
  const Pose end = end_of(path.back());
  const Pose expected{{20 - end.at.x, end.at.y}, Heading::clockwise_from_north(-end.heading.angle())};
  EXPECT_LE(testing::difference(testing::driven(north(17, 4), image, 2000).back(), expected), 1e-10);
}

TEST(SteeredPath, ItsTraceIsAsLongAndHasNoArcBeyondHalfACircle) {
  const SteeredPath path = mixed_path();
  const Path way = trace(path, 1e-6);
  EXPECT_NEAR(length(way), length(path), 1e-5);
  EXPECT_EQ(way.front().from, (Point{3, 4}));
  EXPECT_LE(distance(way.back().to, end_of(path.back()).at), 1e-12);
  const Path circle = trace({arc_from(north(0, 0), 10 * std::numbers::pi, 0.2, Gear::kReverse)});
  ASSERT_EQ(circle.size(), 2U);
  EXPECT_NEAR(length(circle), 10 * std::numbers::pi, 1e-9);
  EXPECT_NEAR(circle.front().curvature, -0.2, 1e-15);  // the way bends to its own right
  EXPECT_TRUE(trace({arc_from(north(0, 0), 0, 0, Gear::kForward)}).empty());
}

}  // namespace
}  // namespace tramline
