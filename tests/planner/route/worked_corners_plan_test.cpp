// Plans whose headland passes are driven straight on into corners.

#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>

#include "tramline/planner/headland_choice/trial_corners.h"
#include "tramline/planner/plan_field.h"

namespace tramline {
namespace {

Machine machine_of_24m() {
  Machine out;
  out.width_m = 24;
  out.radius_m = 8;
  return out;
}

Field block() {
  Field out;
  out.id = "block";
  out.outer = {{0, 0}, {200, 0}, {200, 160}, {0, 160}};
  return out;
}

/// One pass round the field.
PlanSettings whole_with_corners(PassCorners corners) {
  PlanSettings out;
  out.boundary = EdgeKind::kHard;
  out.turns = TurnPlanning::kRoute;
  out.aim = Aim::kWholeCost;
  out.headland_rule = HeadlandRule::kPasses;
  out.headlands = 1;
  out.route.corners = corners;
  return out;
}

Plan planned(const Machine& machine, const PlanSettings& settings) {
  return plan_field(block(), machine, Objective{}, settings);
}

std::ptrdiff_t closed_passes(const Plan& plan) {
  return std::ranges::count_if(plan.headland.passes,
                               [](const HeadlandPass& pass) { return is_closed(pass); });
}

// The pass round the field leaves 24²·(1 − π/4) in each corner, worth 8.50 € at 686 €/ha; into each the
// machine drives 24 m, and stops once for a euro.
TEST(PlansWithWorkedCorners, CostLessWhereWideSwathsLeaveMuchInCorners) {
  const Plan round = planned(machine_of_24m(), whole_with_corners(PassCorners::kRound));
  ASSERT_EQ(closed_passes(round), 1);
  EXPECT_NEAR(round.headland.uncovered_m2, 4 * 24 * 24 * (1 - std::numbers::pi / 4), 1);
  const Plan worked = planned(machine_of_24m(), whole_with_corners(PassCorners::kAuto));
  EXPECT_EQ(closed_passes(worked), 0);
  EXPECT_LE(worked.headland.passes.size(), 5U);
  EXPECT_LT(worked.headland.uncovered_m2, 1);
  EXPECT_LT(whole_cost(worked).euros(), whole_cost(round).euros() - 4 * (8.5 - 1 - 2.5));
  EXPECT_EQ(legs_without_room(worked.route, worked.machine), 0U);
}

TEST(PlansWithWorkedCorners, StayRoundWhereStopsAreDear) {
  Machine machine = machine_of_24m();
  machine.rates.price_per_stop = 100;
  EXPECT_EQ(closed_passes(planned(machine, whole_with_corners(PassCorners::kAuto))), 1);
}

TEST(PlansWithWorkedCorners, AreToldOfAmongThoseCompared) {
  const ExplainedPlan out =
      plan_and_explain(block(), machine_of_24m(), Objective{}, whole_with_corners(PassCorners::kAuto));
  ASSERT_FALSE(out.routes.empty());
  EXPECT_EQ(out.routes.front().kind, Alternative::kWorkedCorners);
}

// Along a line that is given, and where a plan is edited, there is one layout: its corners are worked out as
// well.
TEST(PlansWithWorkedCorners, AreMadeOfGivenLayoutsToo) {
  PlanSettings along = whole_with_corners(PassCorners::kAuto);
  along.guide = {{0, 80}, {200, 80}};
  along.headland_rule = HeadlandRule::kTurns;
  along.headlands = 0;
  EXPECT_EQ(closed_passes(planned(machine_of_24m(), along)), 0);
  along.headland_rule = HeadlandRule::kPasses;
  along.headlands = 1;
  EXPECT_EQ(closed_passes(planned(machine_of_24m(), along)), 0);
  along.aim = Aim::kCost;
  EXPECT_EQ(closed_passes(planned(machine_of_24m(), along)), 1) << "the cost of tracks knows no stops there";

  const PlanSettings settings = whole_with_corners(PassCorners::kAuto);
  const Plan before = planned(machine_of_24m(), settings);
  const Plan edited = plan_edited(before, before.field, before.machine, Objective{}, settings);
  EXPECT_EQ(closed_passes(edited), 0);
}

TEST(PlansWithWorkedCorners, SaveAtLeastAHundredth) {
  EXPECT_FALSE(corners_pay(100, 99.1));
  EXPECT_TRUE(corners_pay(100, 98.9));
}

}  // namespace
}  // namespace tramline
