// Which parts of a pass are clear of what is in its way.

#include "tramline/headland/clear_stretches.h"

#include <gtest/gtest.h>

#include <cmath>

namespace tramline {
namespace {

/// A pass of 10 m to the east that ends in (0, 0).
Path to_the_east() { return {{{-10, 0}, {0, 0}, 0}}; }

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
