// What a route says of room that lacks along its passes and tracks.

#include "tramline/route/connection/driving_ground.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "properties/draws.h"
#include "properties/seeds.h"
#include "route/driven_land.h"

namespace tramline::driving_ground_test {

// A bar 6 m wide goes north beside the western edge of the room, its left end off the land.
class RoomAlongLines : public ::testing::Test {
 protected:
  double lacking_m(double off_m) const {
    return on_.ground.lacking_along_m(testing::northwards({3 - off_m, 10}, 80));
  }

 private:
  testing::DrivenLand on_{testing::room_with_an_arm(), testing::six_metres_wide(6)};
};

TEST_F(RoomAlongLines, LacksNothingOnTheLandAndMillimetresOffIt) {
  EXPECT_EQ(lacking_m(-0.5), 0);
  EXPECT_EQ(lacking_m(0), 0);
  EXPECT_EQ(lacking_m(0.0025), 0);
}

// The distance is found to 2 cm: whatever is more than half a centimetre must be said all the same.
TEST_F(RoomAlongLines, NeverLacksUnsaid) {
  for (const double off_m : {0.0051, 0.0056, 0.01, 0.015, 0.02, 0.03, 0.1, 1.0}) {
    EXPECT_GE(lacking_m(off_m), std::max(kNoticed_m, off_m - 0.02)) << off_m;
    EXPECT_LE(lacking_m(off_m), std::max(kNoticed_m, off_m) + 1e-9) << off_m;
  }
}

// A vehicle and an implement behind it, at an angle to the edge: of a straight way the farthest corner in the
// first or in the last place decides.
TEST(RoomAlongLinesAtAngles, NeverLacksUnsaid) {
  Machine machine = testing::six_metres_wide(6);
  machine.turning.vehicle_width_m = 2.5;
  machine.turning.front_overhang_m = 3;
  machine.turning.implement_offset_m = 1;
  machine.turning.rear_overhang_m = 2;
  const testing::DrivenLand on{testing::room_with_an_arm(), machine};
  testing::for_each_seed(300, [&](std::mt19937_64& random, int) {
    const Heading ahead = Heading::clockwise_from_north(Angle::degrees(uniform(random, -5, 5)));
    const double off_m = uniform(random, -0.005, 0.05);
    double west_m = 0;  // of the machine's axle
    for (const double along_m : {0.0, 40.0})
      for (const Box& part : on.ground.outline().on_machine)
        for (const Point corner : corners_of(part))
          west_m = std::max(west_m, -to_ground({along_m * ahead.unit(), ahead.unit()}, corner).x);
    const double said_m =
        on.ground.lacking_along_m({arc_from({{west_m - off_m, 30}, ahead}, 40, 0, Gear::kForward)});
    if (off_m > kNoticed_m) {
      EXPECT_GE(said_m, std::max(kNoticed_m, off_m - 0.02)) << off_m;
    }
    EXPECT_LE(said_m, off_m > 0 ? std::max(kNoticed_m, off_m + 1e-9) : 0) << off_m;
  });
}

// Thirty metres over land of the tracks, 20 s at 1.5 m/s.
double seconds_over_crop(const Rates& rates, CropDriven how) {
  Machine machine = testing::six_metres_wide(6);
  machine.rates = rates;
  const testing::DrivenLand on{testing::room_with_an_arm(), machine};
  return cost_seconds(testing::northwards({50, 10}, 30), on.ground, how);
}

TEST(CostSeconds, CountBareSoilTwiceAndASixthOfThatMoreAlongATrack) {
  Rates seeding;
  seeding.operation = Operation::kSeeding;
  EXPECT_NEAR(seconds_over_crop(seeding, CropDriven::kAcross), 20 + 20, 1e-9);
  EXPECT_NEAR(seconds_over_crop(seeding, CropDriven::kAlongTrack), 20 + 20.0 / 6, 1e-9);
}

// 1.2 m · 400 €/ha are 0.048 € a metre; at 75 €/h those are 2.304 s.
TEST(CostSeconds, CountStandingCropAtItsPriceAndNoMoreThanTenTimesTheTime) {
  Rates spraying;
  spraying.operation = Operation::kSpraying;
  spraying.price_per_hour = 75;
  spraying.fuel_price = 0;
  spraying.margin_per_ha = 400;
  EXPECT_NEAR(seconds_over_crop(spraying, CropDriven::kAcross), 20 + 20 + 30 * 2.304, 1e-9);
  EXPECT_NEAR(seconds_over_crop(spraying, CropDriven::kAlongTrack), 20 + (20 + 30 * 2.304) / 6, 1e-9);
  spraying.margin_per_ha = 40000;
  EXPECT_NEAR(seconds_over_crop(spraying, CropDriven::kAcross), 20 + 200, 1e-9);
}

}  // namespace tramline::driving_ground_test
