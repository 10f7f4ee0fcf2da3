// Lines of a narrower machine where no line of the machine itself leads.

#include "tramline/route/build/lines_through_narrows.h"

#include <gtest/gtest.h>

#include "route/driven_land.h"

namespace tramline::lines_through_narrows_test {

/// Straight from place to place.
SteeredPath through(const std::vector<Point>& places) {
  SteeredPath out;
  for (std::size_t i = 1; i < places.size(); ++i) {
    const Pose from{places[i - 1], Heading::from_to(places[i - 1], places[i])};
    out.push_back(arc_from(from, distance(places[i - 1], places[i]), 0, Gear::kForward));
  }
  return out;
}

// 6 m wide: what is farther than 4 m from all lines that the machine follows leads through narrows.
class LinesThroughNarrows : public ::testing::Test {
 protected:
  std::vector<FollowedLine> of(const FollowedLine& round_boundary, bool track = false) const {
    return lines_through_narrows({round_boundary}, {{through({{0, 0}, {100, 0}}), false, track}}, on_.ground);
  }

 private:
  testing::DrivenLand on_{testing::room_with_an_arm(), testing::six_metres_wide(6)};
};

// Of places 1 m apart the first that is farther off lies 5 m north.
TEST_F(LinesThroughNarrows, BeginWhereALineLeavesThoseFollowed) {
  const auto lines = of({through({{10, 1}, {50, 1}, {50, 21}}), false});
  ASSERT_EQ(lines.size(), 1U);
  EXPECT_FALSE(lines.front().closed);
  EXPECT_NEAR(lines.front().axle.front().start.at.y, 5, 1e-9);
  EXPECT_NEAR(end_of(lines.front().axle.back()).at.y, 21, 1e-9);
  EXPECT_NEAR(length(lines.front().axle), 16, 1e-9);
}

TEST_F(LinesThroughNarrows, AreAtLeastFourMetresLong) {
  EXPECT_TRUE(of({through({{10, 1}, {50, 1}, {50, 8.5}}), false}).empty());
  EXPECT_EQ(of({through({{10, 1}, {50, 1}, {50, 9}}), false}).size(), 1U);
}

// Round a square of 40 m that begins far from the line and comes back there: one part, of both of its ends.
TEST_F(LinesThroughNarrows, GoOnWhereAClosedLineBegins) {
  const auto lines = of({through({{30, 41}, {70, 41}, {70, 1}, {30, 1}, {30, 41}}), true});
  ASSERT_EQ(lines.size(), 1U);
  EXPECT_FALSE(lines.front().closed);
  EXPECT_EQ(lines.front().axle.front().start.at.x, 30);
  EXPECT_NEAR(lines.front().axle.front().start.at.y, 5, 1e-9);
  EXPECT_NEAR(length(lines.front().axle), 36 + 40 + 36, 1e-9);
}

TEST_F(LinesThroughNarrows, LeadRoundIslandsAsAWhole) {
  const auto lines = of({through({{30, 50}, {70, 50}, {70, 10}, {30, 10}, {30, 50}}), true});
  ASSERT_EQ(lines.size(), 1U);
  EXPECT_TRUE(lines.front().closed);
  EXPECT_NEAR(length(lines.front().axle), 160, 1e-9);
}

TEST_F(LinesThroughNarrows, LeadAlongTracksToo) {
  const auto lines = of({through({{10, 1}, {50, 1}}), false}, true);
  ASSERT_EQ(lines.size(), 1U);
  EXPECT_NEAR(length(lines.front().axle), 40, 1e-9);
}

}  // namespace tramline::lines_through_narrows_test
