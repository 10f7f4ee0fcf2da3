// What chords of arcs leave open, told from land that is thin.

#include "tramline/planner/assembly/arc_slivers.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "tramline/cost/worked/doubled_ground.h"
#include "tramline/geometry/polygon/boolean.h"
#include "tramline/geometry/tolerances.h"
#include "tramline/planner/plan_field.h"

namespace tramline::arc_slivers_test {

constexpr double kPi = std::numbers::pi;
constexpr double kWidth_m = 6, kRadius_m = 10;

/// A headland pass straight on, and then to the left, round a quarter circle about the origin.
Plan with_a_rounded_pass() {
  Plan out;
  out.machine.width_m = kWidth_m;
  HeadlandPass pass;
  pass.path = {{{kRadius_m, -60}, {kRadius_m, 0}, 0}, {{kRadius_m, 0}, {0, kRadius_m}, 1 / kRadius_m}};
  out.headland.passes.push_back(pass);
  return out;
}

/// Between a chord of the inner edge of the arc, from one angle to another, and a place so far off its
/// middle.
Polygon beside_chord(double from_rad, double to_rad, double off_m) {
  const double inner_m = kRadius_m - 0.5 * kWidth_m, middle_rad = 0.5 * (from_rad + to_rad);
  const double middle_m = inner_m * std::cos(0.5 * (to_rad - from_rad)) + off_m;
  const auto at = [](double angle, double away_m) {
    return Point{away_m * std::cos(angle), away_m * std::sin(angle)};
  };
  return {{at(from_rad, inner_m), at(middle_rad, middle_m), at(to_rad, inner_m)}, {}};
}

Polygon strip(double x, double wide_m) {
  return {{{x, -50}, {x + wide_m, -50}, {x + wide_m, 0}, {x, 0}}, {}};
}

TEST(ArcSlivers, AreThoseBesideChordsOfArcs) {
  const Plan plan = with_a_rounded_pass();
  const Polygon sliver = beside_chord(0.5, 0.51, 0.5 * kLayerSagitta);
  ASSERT_TRUE(is_sliver(sliver));
  Region land{sliver};
  drop_slivers_along_arcs(plan, land);
  EXPECT_TRUE(land.empty());
}

TEST(ArcSlivers, AreNoLandBesideStraightWorkUnlessThatIsRounding) {
  const Plan plan = with_a_rounded_pass();
  const double edge = kRadius_m - 0.5 * kWidth_m;
  const Polygon thin = strip(edge - 5e-5, 5e-5), rounding = strip(edge - 2e-6, 2e-6);
  ASSERT_TRUE(is_sliver(thin) && is_sliver(rounding));
  Region land{thin, rounding};
  drop_slivers_along_arcs(plan, land);
  ASSERT_EQ(land.size(), 1u);
  EXPECT_EQ(land.front().outer, thin.outer);
}

TEST(ArcSlivers, AreNoneWhereNoWorkFollowsArcs) {
  Plan plan = with_a_rounded_pass();
  plan.headland.passes.front().path.pop_back();
  Region land{strip(7 - 2e-6, 2e-6)};
  drop_slivers_along_arcs(plan, land);
  EXPECT_EQ(land.size(), 1u);
}

// One pass all round, with arcs in its corners, and on the land behind it tracks 6 m wide, beside which it is
// 0.08 mm wider.
TEST(ArcSlivers, LeaveThinLandBehindAHeadlandInItsLayer) {
  Field field;
  field.outer = {{0, 0}, {200, 0}, {200, 12 + 5 * kWidth_m + 8e-5}, {0, 12 + 5 * kWidth_m + 8e-5}};
  Machine machine;
  machine.width_m = kWidth_m;
  machine.radius_m = 3;
  PlanSettings settings;
  settings.headlands = 1;
  settings.end_rule = EndRule::kInside;
  const Plan plan = plan_field(field, machine, {}, settings);
  ASSERT_EQ(plan.headland.passes.size(), 1u);
  // The strip is 188 m long: 150 cm². Chords of the outer edges of four corners leave up to 38 cm² open.
  EXPECT_NEAR(area(plan.uncovered), plan.tally.uncovered_m2, 4 * 0.5 * kPi * kWidth_m * kLayerSagitta);
}

}  // namespace tramline::arc_slivers_test
