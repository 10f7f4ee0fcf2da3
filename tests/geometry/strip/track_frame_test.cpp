#include "tramline/geometry/strip/track_frame.h"

#include <gtest/gtest.h>

namespace tramline {
namespace {

TEST(TrackFrame, ThatIsNotTurnedIsTheFieldsOwn) {
  const TrackFrame frame;
  for (const Point p : {Point{0, 0}, Point{3.25, -7.5}, Point{-1e6 / 3, 1e-7}}) {
    EXPECT_EQ(frame.to_track(p), p);
    EXPECT_EQ(frame.to_field(p), p);
  }
}

/// Tracks that lie due east run up the turned plane; what is south of them lies to the right.
TEST(TrackFrame, HasTheDirectionAsItsYAndItsRightAsX) {
  const TrackFrame frame(Direction::clockwise_from_north(Angle::degrees(90)));
  const Point p = frame.to_track(Point{5, -2});
  EXPECT_NEAR(p.x, 2, 1e-12);
  EXPECT_NEAR(p.y, 5, 1e-12);
}

}  // namespace
}  // namespace tramline
