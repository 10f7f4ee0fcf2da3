// Ways from the end of one work to the beginning of the next: where the machine backs, and what is told of
// ways without room.

#include "tramline/route/connection/connector.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <utility>

#include "route/driven_land.h"

namespace tramline::connector_test {

using testing::DrivenLand, testing::northwards, testing::six_metres_wide, testing::southwards;

const Ring kHectare{{0, 0}, {100, 0}, {100, 100}, {0, 100}};

// At the edge of a rectangle a machine has to be r + w/2 from it to turn aside: with these 7 m. Ways are
// found that back by so many half radii, 8 m here; what lies between needs no farther.
TEST(Connector, BacksNoFartherThanItTakesToTurn) {
  const DrivenLand on({kHectare, {}}, six_metres_wide(4));
  const SteeredPath left = northwards({40, 20}, 80), entered = southwards({52, 100}, 80);
  const Way way = on.connector.between(left, entered);
  ASSERT_TRUE(way.has_room() && way.backs_out && way.backs_in);
  EXPECT_NEAR(way.path.front().length_m, 8, 1e-9);
  const Way less = on.connector.with_less_backing(way, left, entered);
  EXPECT_TRUE(less.has_room() && less.backs_out && less.backs_in);
  EXPECT_TRUE(on.land.fits(less.path, on.ground.outline()));
  EXPECT_NEAR(less.path.front().length_m, 7, 1e-9);
  EXPECT_NEAR(less.path.back().length_m, 7, 1e-9);
  EXPECT_LT(less.cost_s, way.cost_s - 1.9);
  // Nothing lies between any more.
  EXPECT_EQ(on.connector.with_less_backing(less, left, entered).cost_s, less.cost_s);
}

/// A post of 0.2 m whose southern side lies so far north.
Ring post_at(double south_m) {
  return {{41.5, south_m}, {41.5, south_m + 0.2}, {41.7, south_m + 0.2}, {41.7, south_m}};
}

// A post stands 0.2 m ahead of the bar where the work ends, and the implement is lifted over 1 m straight on:
// the machine has room again behind the post, but none to get there.
TEST(Connector, BacksOutWhereSomethingStandsStraightAhead) {
  Machine machine = six_metres_wide(4);
  machine.turning.lift_m = 1;
  const DrivenLand on({kHectare, {post_at(50.2)}}, machine);
  const Way way = on.connector.between(northwards({40, 20}, 30), southwards({60, 50}, 30));
  EXPECT_TRUE(way.has_room() && way.backs_out && !way.backs_in);
  EXPECT_TRUE(on.land.fits(way.path, on.ground.outline()));
}

// The same, driven from its end: the implement is lowered past the post.
TEST(Connector, BacksInWhereSomethingStandsStraightBefore) {
  Machine machine = six_metres_wide(4);
  machine.turning.lower_m = 1;
  const DrivenLand on({kHectare, {post_at(50.2)}}, machine);
  const Way way = on.connector.between(northwards({60, 20}, 30), southwards({40, 50}, 30));
  EXPECT_TRUE(way.has_room() && way.backs_in && !way.backs_out);
  EXPECT_TRUE(on.land.fits(way.path, on.ground.outline()));
}

constexpr double kTight_m = 1, kDrawbar_m = 2.66, kLift_m = 2.2, kLower_m = 0.5;

/// Behind a drawbar that is longer than the radius.
Machine towing() {
  Machine out = six_metres_wide(kTight_m);
  out.turning.implement = Coupling::kTowed;
  out.turning.drawbar_m = kDrawbar_m;
  out.turning.lift_m = kLift_m;
  out.turning.lower_m = kLower_m;
  return out;
}

/// How far the implement is beside its line behind half a circle and so much straight on, m. The angle b from
/// the drawbar to the machine's heading grows by 1/r of the way, and falls by sin b / L of it; by the
/// midpoint of each of many steps.
double beside_m(double straight_m) {
  double b = 0;
  const auto drive = [&b](double way_m, double curvature) {
    constexpr int kSteps = 20000;
    const double step_m = way_m / kSteps;
    const auto rate = [&](double angle) { return curvature - std::sin(angle) / kDrawbar_m; };
    for (int i = 0; i < kSteps; ++i) b += step_m * rate(b + 0.5 * step_m * rate(b));
  };
  drive(std::numbers::pi * kTight_m, 1 / kTight_m);
  drive(straight_m, 0);
  return kDrawbar_m * std::abs(std::sin(b));
}

// On land four metres wide. Half a circle bends the drawbar by more than a right angle, so that the implement
// is farther beside the line behind the straight on which it is lowered than before.
TEST(Connector, TellsOfWaysWithoutRoomWhereTheImplementIsWhenItIsLowered) {
  const DrivenLand on({{{-3, 0}, {1, 0}, {1, 80}, {-3, 80}}, {}}, towing());
  // The circle begins where the implement is lifted, and ends where it is still to be lowered.
  const SteeredPath left = northwards({0, 20}, 30),
                    entered = southwards({-2 * kTight_m, 50 + kLift_m - kLower_m}, 30);
  const Way way = on.connector.between(left, entered);
  ASSERT_FALSE(way.has_room());
  EXPECT_NEAR(length(way.path), kLift_m + std::numbers::pi * kTight_m + kLower_m, 1e-9);
  ASSERT_GT(beside_m(kLower_m), beside_m(0) + 0.05);
  EXPECT_NEAR(way.lateral_error_m, beside_m(kLower_m), 1e-6);
  const double missing_m = on.land.missing_m(way.path, on.ground.outline());
  EXPECT_GT(way.missing_m, missing_m / 1.1 - 0.02);
  EXPECT_LT(way.missing_m, missing_m + 0.02);
  EXPECT_EQ(on.connector.measured(way).missing_m, missing_m);
  EXPECT_NEAR(way.time_s, length(way.path) / on.machine.turning.turning_speed_mps, 1e-9);
}

double backed_at_first_m(const SteeredPath& path) {
  double out = 0;
  for (const SteeredStretch& stretch : path) {
    if (stretch.gear == Gear::kForward) break;
    out += stretch.length_m;
  }
  return out;
}

// A room of a hectare with an arm 13 m wide north of it. Half a turn takes 2·4 + 6 m, so the machine has to
// back out of the arm: until it is 4 + 3 m south of its mouth, 64 m from the end of the work. The work begins
// 6 m north of the mouth, from where the machine can only go into the arm again.
TEST(Connector, BacksOutOfAnArmByTheWayThatItIsSupposedToHaveCome) {
  const DrivenLand on(testing::room_with_an_arm(), six_metres_wide(4));
  const SteeredPath work = northwards({46.5, 106}, 51), entered = southwards({20, 60}, 40);
  EXPECT_FALSE(on.connector.between(work, entered).has_room());
  const Way way = on.connector.between_as_come(work, entered);
  ASSERT_TRUE(way.has_room() && way.backs_out && way.supposed);
  EXPECT_TRUE(on.land.fits(way.path, on.ground.outline()));
  EXPECT_GE(backed_at_first_m(way.path), 64 - 1e-6);
  const Way known = on.connector.between(northwards({46.5, 80}, 77), entered);
  ASSERT_TRUE(known.has_room() && known.backs_out && !known.supposed);
  EXPECT_GE(backed_at_first_m(known.path), 64 - 1e-6);
}

TEST(Connector, SupposesNothingOfWaysThatHaveRoomWithout) {
  const DrivenLand on({kHectare, {}}, six_metres_wide(4));
  const SteeredPath left = northwards({40, 20}, 80), entered = southwards({52, 100}, 80);
  const Way way = on.connector.between_as_come(left, entered);
  EXPECT_FALSE(way.supposed);
  EXPECT_EQ(way.cost_s, on.connector.between(left, entered).cost_s);
}

}  // namespace tramline::connector_test
