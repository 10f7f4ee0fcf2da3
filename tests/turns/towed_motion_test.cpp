// How towed implements follow, against the equation of motion solved step by step in other variables.

#include "tramline/turns/outline/towed_motion.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "tramline/turns/outline/run_in.h"
#include "tramline/turns/outline/swept_reach.h"

namespace tramline::towed_motion_test {

constexpr double kPi = std::numbers::pi;
const Pose kNorthwards{{0, 0}, Heading::clockwise_from_north(Angle::degrees(0))};

Outline towing(double hitch_m, double drawbar_m, double width_m = 6) {
  Machine machine;
  machine.width_m = width_m;
  machine.turning.implement = Coupling::kTowed;
  machine.turning.implement_offset_m = hitch_m;
  machine.turning.drawbar_m = drawbar_m;
  return outline_of(machine);
}

/// The place of the implement's axle that is pulled by a hitch whose place is known: at every instant it
/// moves along the drawbar, by as much as the hitch does (fourth order).
Point pulled(const SteeredStretch& stretch, const Outline& outline, Point implement, int steps) {
  const double h = stretch.length_m / steps;
  const double change = (stretch.curvature_at_end - stretch.curvature_at_start) / stretch.length_m;
  const auto velocity = [&](double after, Point q) {
    const Placement machine = placed(pose_after(stretch, std::min(after, stretch.length_m)));
    // the machine turns by its curvature for each metre, and the hitch with it
    const double curvature = stretch.curvature_at_start + change * after;
    const Point pull = machine.ahead - (curvature * outline.hitch_m) * left_of(machine.ahead);
    const Point along = to_ground(machine, {-outline.hitch_m, 0}) - q;
    return (dot(pull, along) / dot(along, along)) * along;
  };
  for (int i = 0; i < steps; ++i) {
    const double s = i * h;
    const Point k1 = velocity(s, implement);
    const Point k2 = velocity(s + 0.5 * h, implement + (0.5 * h) * k1);
    const Point k3 = velocity(s + 0.5 * h, implement + (0.5 * h) * k2);
    const Point k4 = velocity(s + h, implement + h * k3);
    implement = implement + (h / 6) * (k1 + 2 * k2 + 2 * k3 + k4);
  }
  return implement;
}

void expect_as_pulled(const SteeredPath& path, const Outline& outline, double tolerance) {
  const TowedMotion motion(path, outline);
  Point implement = to_ground(placed(path.front().start), {-outline.hitch_m - outline.drawbar_m, 0});
  for (std::size_t i = 0; i < path.size(); ++i) {
    EXPECT_NEAR(distance(motion.implement(i, 0).at, implement), 0, tolerance) << "at joint " << i;
    implement = pulled(path[i], outline, implement, 4000);
    EXPECT_NEAR(distance(motion.implement(i, path[i].length_m).at, implement), 0, tolerance)
        << "after stretch " << i;
  }
}

SteeredPath joined(const Pose& start, const std::vector<std::array<double, 3>>& stretches) {
  SteeredPath out;
  Pose at = start;
  for (const auto& [length, from, to] : stretches) {
    out.push_back({at, length, from, to, Gear::kForward});
    at = end_of(out.back());
  }
  return out;
}

TEST(TowedMotion, FollowsThroughLinesAndArcs) {
  const SteeredPath path =
      joined(kNorthwards, {{3, 0, 0}, {5, -0.15, -0.15}, {22, 0.16, 0.16}, {5, -0.15, -0.15}, {8, 0, 0}});
  expect_as_pulled(path, towing(0, 5), 1e-10);
  expect_as_pulled(path, towing(1.2, 4), 1e-10);
  expect_as_pulled(path, towing(-0.8, 4), 1e-10);
}

TEST(TowedMotion, FollowsWhereNoSteadyAngleIs) {
  // curvature · drawbar = 1 just, and above
  expect_as_pulled(joined(kNorthwards, {{20, 0.2, 0.2}}), towing(0, 5), 1e-10);
  expect_as_pulled(joined(kNorthwards, {{12, 0.3, 0.3}, {4, 0, 0}}), towing(0, 5), 1e-10);
  expect_as_pulled(joined(kNorthwards, {{12, -0.3, -0.3}}), towing(1, 7), 1e-10);
}

TEST(TowedMotion, FollowsThroughClothoids) {
  expect_as_pulled(
      joined(kNorthwards, {{4, 0, 0.16}, {15, 0.16, 0.16}, {8, 0.16, -0.16}, {4, -0.16, 0}, {3, 0, 0}}),
      towing(1.2, 4), 1e-7);
  expect_as_pulled(joined(kNorthwards, {{3, 0, 0.2}, {6, 0.2, -0.2}}), towing(0, 2.5), 1e-7);
}

TEST(TowedMotion, OnALineTheTangentOfHalfTheAngleFalls) {
  const Heading thirty_to_the_right = Heading::clockwise_from_north(Angle::degrees(30));
  const TowedMotion motion({arc_from(kNorthwards, 6, 0, Gear::kForward)}, towing(0, 4), thirty_to_the_right);
  const double after = 2 * std::atan(std::tan(kPi / 12) * std::exp(-6 / 4.0));
  EXPECT_NEAR(motion.angle_at_end().radians(), after, 1e-14);
  // the line is to the left of the drawbar, which points to the right: the implement is on the left
  EXPECT_NEAR(motion.implement(0, 6).at.x, -4 * std::sin(after), 1e-13);
  EXPECT_NEAR(motion.pose(6).at.y, 6 - 4 * std::cos(after), 1e-13);
}

TEST(TowedMotion, OnACircleTendsToTheSteadyAngle) {
  const TowedMotion motion({arc_from(kNorthwards, 200, 0.1, Gear::kForward)}, towing(0, 5));
  EXPECT_NEAR(motion.angle_at_end().radians(), std::asin(0.5), 1e-12);
  EXPECT_NEAR(distance(motion.implement(0, 200).at, {-10, 0}), std::sqrt(75.0), 1e-12);
}

/// The hitch drives a circle of √(r² + l²), and the implement one of √(r² + l² − L²).
TEST(TowedMotion, BehindAHitchOffTheAxleRunsOnItsOwnSteadyCircle) {
  const TowedMotion motion({arc_from(kNorthwards, 300, -0.1, Gear::kForward)}, towing(2, 5));
  EXPECT_NEAR(distance(motion.implement(0, 300).at, {10, 0}), std::sqrt(100.0 + 4 - 25), 1e-12);
}

TEST(TowedMotion, TheDrawbarDoesNotJumpWhereTheHitchDoes) {
  const SteeredPath path = joined(kNorthwards, {{10, 0, 0}, {10, 0.15, 0.15}});
  const TowedMotion motion(path, towing(1.5, 4));
  EXPECT_NEAR(distance(motion.implement(0, 10).ahead, motion.implement(1, 0).ahead), 0, 1e-15);
  EXPECT_NEAR(distance(motion.implement(0, 10).at, motion.implement(1, 0).at), 0, 1e-12);
}

TEST(TowedMotion, OfPiecesIsWithinItsBounds) {
  const Outline outline = towing(1.2, 4, 24);
  const SteeredPath path =
      joined(kNorthwards, {{4, 0, 0.16}, {15, 0.16, 0.16}, {6, 0.16, 0}, {10, 0, 0}, {9, -0.3, -0.3}});
  const TowedMotion motion(path, outline);
  double worst = 0;
  for (std::size_t k = 0; k < path.size(); ++k)
    for (const double parts : {1.0, 3.0, 10.0, 100.0}) {
      const double pieces = motion.pieces(k) * parts;
      for (double i = 0; i < pieces; i += std::ceil(parts / 5)) {
        const double from = i / pieces * path[k].length_m, to = (i + 1) / pieces * path[k].length_m;
        const MotionPiece piece = motion.motion(k, from, to);
        for (const double share : {0.1, 0.3, 0.5, 0.8, 1.0}) {
          const Placement even =
              end_of(EvenMotion{piece.even.start, share * piece.even.way_m, share * piece.even.turn_rad});
          const Placement exact = motion.implement(k, from + share * (to - from));
          for (const Box& part : outline.on_implement)
            for (const Point corner : corners_of(part)) {
              const double off = distance(to_ground(even, corner), to_ground(exact, corner));
              EXPECT_LE(off, piece.margin_m(part) + 1e-7);
              if (off > 1e-6) worst = std::max(worst, off / piece.margin_m(part));
            }
        }
      }
    }
  EXPECT_GT(worst, 0.2) << "the bound is far from what it bounds";
}

TEST(SweptReach, OfATowedBarIsThatOfAFineLookAlongThePath) {
  const Outline outline = towing(1.2, 4, 12);
  const SteeredPath path = joined(kNorthwards, {{3, 0, 0.16}, {12, 0.16, 0.16}, {7, 0, 0}});
  const TowedMotion motion(path, outline);
  for (const Point unit : {Point{1, 0}, Point{0, 1}, Point{-0.6, 0.8}}) {
    double most = -1e9;
    for (std::size_t k = 0; k < path.size(); ++k)
      for (int i = 0; i <= 20000; ++i)
        for (const Box& part : outline.on_implement)
          for (const Point corner : corners_of(part))
            most = std::max(most,
                            dot(unit, to_ground(motion.implement(k, path[k].length_m * i / 20000), corner)));
    const double reach = swept_reach_m(path, outline, {0, 0}, unit);
    EXPECT_NEAR(reach, most, 1e-6);
    EXPECT_GE(reach, most - 1e-9);
  }
}

TEST(RunIn, BringsTheErrorToTheTolerance) {
  for (const double degrees : {-140.0, -60.0, 5.0, 30.0, 90.0, 170.0}) {
    const Angle angle = Angle::degrees(degrees);
    const double way = run_in_m(angle, 5, 0.03);
    EXPECT_NEAR(std::abs(lateral_error_m(angle, 5, way)), 0.03, 1e-12);
    EXPECT_GT(std::abs(lateral_error_m(angle, 5, way - 0.1)), 0.03);
    EXPECT_LE(std::abs(lateral_error_m(angle, 5, way)), 2 * 5 * std::tan(std::abs(angle.radians()) / 2));
  }
  EXPECT_EQ(run_in_m(Angle::degrees(0.1), 5, 0.03), 0) << "it is on the line already";
  EXPECT_EQ(run_in_m(Angle::degrees(80), 5, 6), 0);
}

/// After a turn by a quarter the implement lags behind.
TEST(RunIn, AfterAPathIsThatOfItsLastAngle) {
  const SteeredPath path = joined(kNorthwards, {{10, 0, 0}, {3 * kPi, 1.0 / 6, 1.0 / 6}});
  const Outline outline = towing(0, 4);
  const TowedMotion motion(path, outline);
  // the machine heads west at (−6, 16): what is north of it is on its right
  EXPECT_NEAR(lateral_error_m(path, outline, 0), 16 - motion.implement(1, 3 * kPi).at.y, 1e-9);
  const double way = run_in_m(path, outline, 0.05);
  EXPECT_NEAR(std::abs(lateral_error_m(path, outline, way)), 0.05, 1e-12);
}

}  // namespace tramline::towed_motion_test
