// Stretches of lines along which a machine may back with about the same heading.

#include "tramline/route/backing/gentle_run.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "route/backing/backing_scenes.h"

namespace tramline {
namespace {

constexpr double kTurnsBy_m = 6;

/// Straight on, then an arc to the left or (a negative curvature) to the right, and straight on again.
SteeredPath round_a_corner(double before_m, double arc_m, double curvature, double behind_m) {
  SteeredPath out;
  Pose at{{0, 0}, testing::towards_deg(0)};
  for (const auto& [length_m, bends] : {std::pair{before_m, 0.0}, {arc_m, curvature}, {behind_m, 0.0}}) {
    if (length_m == 0) continue;
    out.push_back(arc_from(at, length_m, bends, Gear::kForward));
    at = end_of(out.back());
  }
  return out;
}

TEST(GentleRun, IsAllOfALineThatBendsLittle) {
  const SteeredPath line = round_a_corner(10, 5, 1.0 / 12, 20);
  const GentleRun run = first_run(line, kTurnsBy_m);
  EXPECT_EQ(length(run.line), 35);
  EXPECT_NEAR(run.bent, std::sin(5.0 / 12), 1e-9);
  EXPECT_TRUE(run.to_end);
  EXPECT_FALSE(longest_run_behind_bends(line, kTurnsBy_m));
}

// Nothing of a line that begins sharper than the machine turns; and what lies behind a bend is told by where
// it begins along all of the line.
TEST(GentleRun, BehindABendBeginsWhereTheBendEnds) {
  EXPECT_TRUE(first_run(round_a_corner(0, 5, 1.0 / 5, 20), kTurnsBy_m).line.empty());
  const double quarter_m = 12 * std::numbers::pi / 2;
  const auto behind = longest_run_behind_bends(round_a_corner(10, quarter_m, 1.0 / 12, 50), kTurnsBy_m);
  ASSERT_TRUE(behind);
  EXPECT_NEAR(behind->begins_m, 10 + quarter_m, 1e-9);
  EXPECT_NEAR(length(behind->line), 50, 1e-9);
}

}  // namespace
}  // namespace tramline
