// What machines take up of the ground and sweep in a turn, by hand.

#include "tramline/turns/outline/outline.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "tramline/geometry/polygon/boolean.h"
#include "tramline/turns/outline/even_motion.h"
#include "tramline/turns/outline/swept_outline.h"
#include "tramline/turns/outline/swept_reach.h"

namespace tramline::outline_test {

constexpr double kPi = std::numbers::pi;
const Pose kOrigin{{0, 0}, Heading::clockwise_from_north(Angle::degrees(0))};

void expect_box(const Box& box, double rear, double front, double right, double left) {
  EXPECT_DOUBLE_EQ(box.min_x, rear);
  EXPECT_DOUBLE_EQ(box.max_x, front);
  EXPECT_DOUBLE_EQ(box.min_y, right);
  EXPECT_DOUBLE_EQ(box.max_y, left);
}

/// 12 m wide, 2 m behind the axle and 1.5 m deep, on a vehicle of 4 by 2.5 m; least radius 6 m.
Machine mounted() {
  Machine out;
  out.width_m = 12;
  out.radius_m = 6;
  out.turning.implement_offset_m = 2;
  out.turning.rear_overhang_m = 1.5;
  out.turning.front_overhang_m = 4;
  out.turning.vehicle_width_m = 2.5;
  return out;
}

TEST(Outline, WithoutFurtherWordIsABarAtTheAxle) {
  Machine machine;
  machine.width_m = 6;
  const Outline outline = outline_of(machine);
  ASSERT_EQ(outline.on_machine.size(), 1U);
  expect_box(outline.on_machine[0], 0, 0, -3, 3);
  EXPECT_FALSE(outline.tows());
}

TEST(Outline, OfAMountedImplementIsVehicleAndBar) {
  const Outline outline = outline_of(mounted());
  ASSERT_EQ(outline.on_machine.size(), 2U);
  expect_box(outline.on_machine[0], 0, 4, -1.25, 1.25);
  expect_box(outline.on_machine[1], -3.5, -2, -6, 6);
}

TEST(Outline, OfATowedImplementIsBarAndDrawbarOfTheirOwn) {
  Machine machine = mounted();
  machine.turning.implement = Coupling::kTowed;
  machine.turning.drawbar_m = 5;
  const Outline outline = outline_of(machine);
  ASSERT_EQ(outline.on_machine.size(), 1U);
  ASSERT_EQ(outline.on_implement.size(), 2U);
  expect_box(outline.on_implement[0], -1.5, 0, -6, 6);
  expect_box(outline.on_implement[1], 0, 5, 0, 0);
  EXPECT_EQ(outline.hitch_m, 2);
  machine.turning.drawbar_m = 0;
  EXPECT_EQ(outline_of(machine).on_machine.size(), 2U) << "without a drawbar it turns with the machine";
}

/// From the origin northwards, round to the left: the centre is 6 m to the west. The bar's rear outer corner
/// is 6 + 6 m beside it and 3.5 m behind the axle.
TEST(SweptReach, OfAHalfCircleIsTheCircleOfTheOuterRearCorner) {
  const SteeredPath half = {arc_from(kOrigin, 6 * kPi, 1.0 / 6, Gear::kForward)};
  const Outline outline = outline_of(mounted());
  const double outer = std::sqrt((6.0 + 6) * (6 + 6) + 3.5 * 3.5);
  EXPECT_NEAR(swept_reach_m(half, outline, {-6, 0}, {1, 0}), outer, 1e-12);
  EXPECT_NEAR(swept_reach_m(half, outline, {-6, 0}, {0, 1}), outer, 1e-12);
  EXPECT_NEAR(swept_reach_m(half, outline, {-6, 0}, {-1, 0}), 12, 1e-12) << "it ends before";
  EXPECT_NEAR(swept_reach_m(half, outline, {0, 0}, {0, -1}), 4, 1e-12) << "the vehicle's front at the end";
}

/// Of a quarter only the start's corner gets as far down, and the end's as far west; the outermost east is
/// where the corner passes the height of the centre.
TEST(SweptReach, OfAQuarterCircleHasTheExtremesThatAreOnTheWay) {
  const SteeredPath quarter = {arc_from(kOrigin, 3 * kPi, 1.0 / 6, Gear::kForward)};
  const Outline outline = outline_of(mounted());
  const double outer = std::hypot(12, 3.5);
  EXPECT_NEAR(swept_reach_m(quarter, outline, {-6, 0}, {1, 0}), outer, 1e-12);
  EXPECT_NEAR(swept_reach_m(quarter, outline, {-6, 0}, {0, 1}), 12, 1e-12);
  // the vehicle's front at the end, 4 m ahead of the axle, which is above the centre
  EXPECT_NEAR(swept_reach_m(quarter, outline, {-6, 0}, {-1, 0}), 4, 1e-12);
}

TEST(SweptReach, DependsOnTheSenseInWhichThePathIsDriven) {
  const SteeredPath quarter = {arc_from(kOrigin, 3 * kPi, 1.0 / 6, Gear::kForward)};
  const Outline outline = outline_of(mounted());
  // Driven the other way, the bar follows the axle southwards: 12 m beside the centre, then 2 m north of the
  // axle, and at its start 3.5 m behind it, which is east of the centre at the height of 6 m.
  const SteeredPath other = turned_round(quarter);
  EXPECT_NEAR(swept_reach_m(other, outline, {-6, 0}, {1, 0}), 12, 1e-9);
  EXPECT_NEAR(swept_reach_m(other, outline, {-6, 0}, {0, 1}), std::hypot(12, 3.5), 1e-9);
}

TEST(SweptReach, InReverseGoesRoundTheSameCircle) {
  const SteeredPath back = {arc_from(kOrigin, 3 * kPi, 1.0 / 6, Gear::kReverse)};
  // clockwise about (−6, 0), down to (−6, −6)
  EXPECT_NEAR(swept_reach_m(back, outline_of(mounted()), {-6, 0}, {0, -1}), std::hypot(12, 3.5), 1e-12);
}

TEST(SweptReach, OnALine) {
  const SteeredPath line = {arc_from(kOrigin, 10, 0, Gear::kForward)};
  EXPECT_DOUBLE_EQ(swept_reach_m(line, outline_of(mounted()), {0, 0}, {0, 1}), 14);
  EXPECT_DOUBLE_EQ(swept_reach_m(line, outline_of(mounted()), {1, 0}, {1, 0}), 5);
  EXPECT_DOUBLE_EQ(swept_reach_m(line, outline_of(mounted()), {0, 0}, {0, -1}), 3.5);
}

TEST(SweptReach, OfAnArcAsWideAsTheEarthIsThatOfALine) {
  const SteeredPath nearly = {arc_from(kOrigin, 10, 1e-13, Gear::kForward)};
  EXPECT_NEAR(swept_reach_m(nearly, outline_of(mounted()), {0, 0}, {0, 1}), 14, 1e-9);
  EXPECT_NEAR(swept_reach_m(nearly, outline_of(mounted()), {0, 0}, {1, 0}), 6, 1e-9);
}

TEST(SweptReach, OfAClothoidIsThatOfAFineLookAlongIt) {
  const SteeredPath path = {{kOrigin, 15, 0, 0.25, Gear::kForward}};
  const Outline outline = outline_of(mounted());
  for (const Point unit : {Point{1, 0}, Point{0, 1}, Point{-0.6, 0.8}, Point{0.28, -0.96}}) {
    double most = -1e9;
    for (int i = 0; i <= 20000; ++i)
      for (const Box& part : outline.on_machine)
        for (const Point corner : corners_of(part))
          most = std::max(most, dot(unit, to_ground(placed(pose_after(path[0], 15 * i / 20000.0)), corner)));
    const double reach = swept_reach_m(path, outline, {0, 0}, unit);
    EXPECT_NEAR(reach, most, 5e-8);
    EXPECT_GE(reach, most - 1e-9);
  }
}

TEST(SweptOutline, OfABarOnALineIsARectangle) {
  Machine machine;
  machine.width_m = 6;
  const Region swept = swept_outline({arc_from(kOrigin, 10, 0, Gear::kForward)}, outline_of(machine), 0.01);
  EXPECT_NEAR(area(swept), 60, 1e-4);
}

/// A bar at the axle, wider than the circle: the inner end goes round behind the centre, on a circle of
/// radius b − r.
TEST(SweptOutline, OfABarRoundAHalfCircleIsTwoHalfDiscs) {
  Machine machine;
  machine.width_m = 16;
  const Region swept =
      swept_outline({arc_from(kOrigin, 6 * kPi, 1.0 / 6, Gear::kForward)}, outline_of(machine), 1e-3);
  EXPECT_NEAR(area(swept), 0.5 * kPi * (14.0 * 14 + 2 * 2), 0.05);
}

/// From the line of the bar to its outer corner all is swept, and of the inside all but the disc that the
/// front line of the bar touches from outside.
TEST(SweptOutline, OfAFullCircleIsARing) {
  Machine machine;
  machine.width_m = 4;
  machine.turning.implement_offset_m = 2;
  machine.turning.rear_overhang_m = 1;
  const Region swept =
      swept_outline({arc_from(kOrigin, 12 * kPi, 1.0 / 6, Gear::kForward)}, outline_of(machine), 1e-3);
  EXPECT_NEAR(area(swept), kPi * ((8.0 * 8 + 3 * 3) - (4.0 * 4 + 2 * 2)), 0.08);
}

TEST(SweptOutline, ReachesAsFarAsTheSweptReach) {
  const SteeredPath path = {arc_from(kOrigin, 7, -1.0 / 7, Gear::kForward)};
  for (const Outline& outline : {outline_of(mounted())}) {
    const Box box = bounds(swept_outline(path, outline, 1e-4));
    EXPECT_NEAR(box.max_x, swept_reach_m(path, outline, {0, 0}, {1, 0}), 1.1e-4);
    EXPECT_NEAR(box.max_y, swept_reach_m(path, outline, {0, 0}, {0, 1}), 1.1e-4);
    EXPECT_NEAR(-box.min_x, swept_reach_m(path, outline, {0, 0}, {-1, 0}), 1.1e-4);
    EXPECT_NEAR(-box.min_y, swept_reach_m(path, outline, {0, 0}, {0, -1}), 1.1e-4);
  }
}

TEST(EvenMotion, ItsBoxHoldsTheSweepAndNoMore) {
  for (const double turn : {-7.0, -4.0, -1.2, 0.6, 2.0, 3.3, 6.0}) {
    const EvenMotion motion{{{3, 4}, {0.6, 0.8}}, 9, turn};
    const Box part{-3, -5, 1, 2};
    Box seen;
    for (int i = 0; i <= 20000; ++i)
      for (const Point corner : corners_of(part))
        seen.extend(to_ground(end_of(EvenMotion{motion.start, 9 * i / 20000.0, turn * i / 20000.0}), corner));
    const Box box = swept_box(part, motion);
    EXPECT_NEAR(box.min_x, seen.min_x, 1e-5) << turn;
    EXPECT_NEAR(box.min_y, seen.min_y, 1e-5) << turn;
    EXPECT_NEAR(box.max_x, seen.max_x, 1e-5) << turn;
    EXPECT_NEAR(box.max_y, seen.max_y, 1e-5) << turn;
  }
}

TEST(EvenMotion, NearlyStraightItsBoxHoldsTheSweep) {
  const EvenMotion motion{{{3, 4}, {0.6, 0.8}}, 9, 0.49};
  const Box part{-3, -5, 1, 2}, box = swept_box(part, motion);
  for (int i = 0; i <= 1000; ++i)
    for (const Point corner : corners_of(part)) {
      const Point p = to_ground(end_of(EvenMotion{motion.start, 9 * i / 1000.0, 0.49 * i / 1000}), corner);
      EXPECT_TRUE(box.min_x <= p.x && p.x <= box.max_x && box.min_y <= p.y && p.y <= box.max_y);
    }
}

/// Along pieces of clothoids of all lengths.
TEST(EvenMotion, OfAClothoidIsWithinItsBounds) {
  const SteeredStretch clothoid{kOrigin, 12, 0.2, -0.1, Gear::kReverse};
  const Box part{-4, -8, 2, 8};
  double worst = 0;
  for (const double from : {0.0, 1.0, 5.0, 8.9})
    for (const double h : {0.1, 1.0, 3.0}) {
      const MotionPiece piece = machine_motion(clothoid, from, from + h);
      for (int i = 0; i <= 50; ++i) {
        const double share = i / 50.0;
        const Placement even =
            end_of(EvenMotion{piece.even.start, share * piece.even.way_m, share * piece.even.turn_rad});
        const Placement exact = placed(pose_after(clothoid, from + share * h));
        for (const Point corner : corners_of(part)) {
          const double off = distance(to_ground(even, corner), to_ground(exact, corner));
          EXPECT_LE(off, piece.margin_m(part) + 1e-12);
          worst = std::max(worst, off / piece.margin_m(part));
        }
      }
    }
  EXPECT_GT(worst, 0.5) << "the bound is far from what it bounds";
}

}  // namespace tramline::outline_test
