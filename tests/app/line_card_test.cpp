// What a line card says, against values worked out by hand.

#include "report/line_card.h"

#include <gtest/gtest.h>

#include "support/small_plan.h"

namespace tramline::app {
namespace {

TEST(LineCard, PositionsAreInDegreesAndInMinutes) {
  EXPECT_EQ(position_text({9.5, 52.25}), "52.2500000° N, 9.5000000° E, or 52° 15.00000' N, 9° 30.00000' E");
  EXPECT_EQ(position_text({-0.1, -33.0000001}),
            "33.0000001° S, 0.1000000° W, or 33° 0.00001' S, 0° 6.00000' W");
  // 59.999999 minutes are a degree.
  EXPECT_EQ(position_text({0, 10.99999999}), "11.0000000° N, 0.0000000° E, or 11° 0.00000' N, 0° 0.00000' E");
}

TEST(LineCard, NumbersThatFollowOneAnotherAreRuns) {
  EXPECT_EQ(runs_text({1, 2, 3, 4}), "1 to 4");
  EXPECT_EQ(runs_text({5, 4, 3, 1, 2}), "5 to 3, 1, 2");
  EXPECT_EQ(runs_text({0, 2, 4, 3, 2, 1, 0, -1}), "0, 2, 4 to -1");
  EXPECT_EQ(runs_text({7, 7}), "7, 7");
  EXPECT_EQ(runs_text({}), "");
}

// Two tracks to the east and back, the second 3 m north of the first: on the left of A-B.
TEST(LineCard, TracksAreCountedFromTheLineToItsRight) {
  const Plan plan = testing_support::small_plan();
  const auto order = [&](Point a, Point b, int track) {
    return card_rows(plan, {{"AB 1", 0, track, a, b}}).back();
  };
  EXPECT_TRUE(order({0, 1.5}, {100, 1.5}, 0).ends_with(": 0, -1.")) << order({0, 1.5}, {100, 1.5}, 0);
  EXPECT_TRUE(order({100, 1.5}, {0, 1.5}, 0).ends_with(": 0, 1."));
  EXPECT_TRUE(order({0, 4.5}, {100, 4.5}, 1).ends_with(": 1, 0."));
}

// 200 m at 2.5 m/s are 80 s.
TEST(LineCard, HoursWithoutARouteAreThoseAtWork) {
  Plan plan = testing_support::small_plan();
  plan.tally.track_length_m = 200;
  const std::vector<std::string> rows = card_rows(plan, {});
  ASSERT_EQ(rows.size(), 3U);
  EXPECT_EQ(rows[2], "Time at work: 0.02 h for 0.20 km at 2.5 m/s; turns come on top, no route is planned.");
  EXPECT_EQ(rows[1], "Headland: none.");
}

}  // namespace
}  // namespace tramline::app
