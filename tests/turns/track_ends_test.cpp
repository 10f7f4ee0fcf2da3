// Where the axle is when the work ends and begins, by hand.

#include "tramline/turns/track_ends.h"

#include <gtest/gtest.h>

namespace tramline {
namespace {

const Heading kNorth = Heading::clockwise_from_north(Angle::degrees(0));

TEST(TrackEnds, WithoutFurtherWordTheBarIsAtTheAxle) {
  EXPECT_EQ(pose_after_work({3, 5}, kNorth, {}).at, (Point{3, 5}));
  EXPECT_EQ(pose_before_work({3, 5}, kNorth, {}).at, (Point{3, 5}));
}

TEST(TrackEnds, AMountedImplementIsBehindTheAxleAndLiftedOnTheWay) {
  Turning turning;
  turning.implement_offset_m = 2.5;
  turning.lift_m = 1;
  turning.lower_m = 1.5;
  EXPECT_EQ(pose_after_work({0, 100}, kNorth, turning).at, (Point{0, 103.5}));
  EXPECT_EQ(pose_before_work({0, 0}, kNorth, turning).at, (Point{0, 1}));
}

TEST(TrackEnds, ATowedImplementIsBehindItsDrawbar) {
  Turning turning;
  turning.implement = Coupling::kTowed;
  turning.implement_offset_m = 0.5;
  turning.drawbar_m = 4;
  EXPECT_EQ(pose_after_work({0, 100}, kNorth, turning).at, (Point{0, 104.5}));
}

}  // namespace
}  // namespace tramline
