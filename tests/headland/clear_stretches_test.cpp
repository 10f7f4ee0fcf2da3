// Where passes that are open at an end stop.

#include "tramline/headland/clear_stretches.h"

#include <gtest/gtest.h>

#include <cmath>

namespace tramline {
namespace {

constexpr double kWidth_m = 6, kMost_m = 12;

/// A pass of 10 m to the east that ends in (0, 0).
Path to_the_east() { return {{{-10, 0}, {0, 0}, 0}}; }

double gone_on_m(const std::vector<SwathLimit>& limits) {
  return driven_to_the_end(to_the_east(), limits, kWidth_m, kMost_m).back().to.x;
}

/// Land behind x = 7, and land north of a line that falls by 1 in 10 from (0, 9).
const Ring kAhead{{7, -20}, {30, -20}, {30, 20}, {7, 20}};
const Ring kBeside{{0, 9}, {60, 3}, {60, 40}, {0, 40}};

TEST(DrivenToTheEnd, GoesOnUntilTheSwathTouchesWhatIsAhead) {
  EXPECT_NEAR(gone_on_m({}), kMost_m, 1e-9);
  EXPECT_NEAR(gone_on_m({{kAhead, 0}}), 7, 1e-6);
  EXPECT_NEAR(gone_on_m({{kBeside, 0}}), kMost_m, 1e-6) << "6 m from the swath";
}

// The front left corner of the swath, (run, 3), is (6 − run/10)/√1.01 from the line.
TEST(DrivenToTheEnd, KeepsADistanceBesideTheSwathToo) {
  EXPECT_NEAR(gone_on_m({{kBeside, 5}}), 10 * (6 - 5 * std::sqrt(1.01)), 2e-3);
  EXPECT_NEAR(gone_on_m({{kBeside, 5.9}}), 10 * (6 - 5.9 * std::sqrt(1.01)), 2e-3);
  EXPECT_NEAR(gone_on_m({{kAhead, 4}}), 3, 2e-3);
  EXPECT_EQ(gone_on_m({{kBeside, 8}}), 0) << "too near already";
}

TEST(ClearStretches, LeaveOutWhatIsTooNear) {
  // An obstacle of 2 m on the north side of the line: a swath of 6 m has to keep 3 m from it, so the line is
  // clear but for √(3² − 1²) m before and behind its corners, 1 m off the line.
  const Ring obstacle{{-6, 1}, {-6, 3}, {-4, 3}, {-4, 1}};
  const std::vector<Path> parts = clear_stretches(to_the_east(), {{obstacle, 3}}, 1);
  const double away_m = std::sqrt(8.0);
  ASSERT_EQ(parts.size(), 2U);
  EXPECT_NEAR(parts[0].back().to.x, -6 - away_m, 1e-5);
  EXPECT_NEAR(parts[1].front().from.x, -4 + away_m, 1e-5);
}

}  // namespace
}  // namespace tramline
