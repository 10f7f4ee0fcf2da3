// Routes of machines with a tractor, a drawbar or an implement behind the axle hold.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "check/route/planned_routes.h"
#include "tramline/check/verify.h"
#include "tramline/planner/plan_field.h"

namespace tramline::planned_routes {
namespace {

TEST(PlannedRoutesOfMachines, hold_for_machines_that_carry_tow_and_reverse) {
  Machine of = with_tractor(machine(6, 6));
  for (const bool reverse : {false, true}) {
    of.turning.reverse = reverse;
    expect_route_holds(l_shape(), of, whole_route(0));
  }
  of.turning.reverse = false;
  of.turning.implement = Coupling::kTowed;
  of.turning.drawbar_m = 4;
  expect_route_holds(l_shape(), of, whole_route(0));
}

// Its hitch swings through metres while the axle turns on the spot; and where the land ends with the track,
// the drawbar has no room beyond it, so that all ends are stops.
TEST(PlannedRoutesOfMachines, hold_for_machines_that_turn_within_their_drawbar) {
  Machine of = machine(6, 0);
  of.turning.implement_offset_m = 4;
  of.turning.implement = Coupling::kTowed;
  of.turning.drawbar_m = 6;
  PlanSettings settings = whole_route(0);
  expect_route_holds(field_of(box(0, 0, 90, 60)), of, settings);
  settings.boundary = EdgeKind::kHard;
  settings.guide = {{3, 0}, {3, 60}};
  const Plan plan = expect_route_holds(field_of(box(0, 0, 90, 60)), of, settings);
  EXPECT_EQ(plan.tally.stops, 2 * plan.tally.pieces);
}

// Where the axle is ahead of the implement, its places on a pass are others one way round than the other.
TEST(PlannedRoutesOfMachines, hold_round_closed_passes_with_an_implement_behind_the_axle) {
  for (const double wide_m : {85.0, 121.0})
    expect_route_holds(field_of(box(0, 0, 203, wide_m)), with_tractor(machine(6, 6)), whole_route(3));
}

// Passes next but one are 6 m apart, less the steps between places that planner and verifier look at: by one
// of them more than 1.5 widths, by the other less.
TEST(PlannedRoutesOfMachines, hold_round_passes_whose_places_are_about_as_far_apart_as_are_looked_at) {
  PlanSettings settings = whole_route(3);
  settings.aim = Aim::kWholeCost;
  expect_route_holds(field_of(box(0, 0, 120, 85)), machine(3, 6), settings);
}

// Its implement works behind the axle: where the axle comes out of the corner of a pass, r = 6 m, the rear
// corner of the bar, 3 m behind and 3 m beside it, is farther from the middle of the arc than the boundary, 6
// m + 3 m.
TEST(PlannedRoutesOfMachines, say_where_an_implement_swings_out_at_corners) {
  const Plan plan =
      plan_field(field_of(box(0, 0, 200, 100)), with_tractor(machine(6, 6)), {}, whole_route(3));
  const check::Verdict verdict = check::verify(plan);
  std::vector<check::Violation> all = verdict.violations;
  all.insert(all.end(), verdict.findings.begin(), verdict.findings.end());
  const double swung_m = std::hypot(6 + 3, 2 + 1) - (6 + 3);
  int swings = 0;
  for (const check::Violation& v : all) {
    EXPECT_EQ(v.rule, check::Rule::kRouteRoom) << v.what;
    if (v.what.find("(headland)") == std::string::npos) continue;
    EXPECT_NEAR(v.amount, swung_m, 0.01) << v.what;
    ++swings;
  }
  EXPECT_EQ(swings, 1);
}

TEST(PlannedRoutesOfMachines, hold_with_the_warning_of_corners_that_swing_out) {
  Plan plan = plan_field(field_of(box(0, 0, 200, 100)), with_tractor(machine(6, 6)), {}, whole_route(3));
  EXPECT_EQ(first_warning_at_fault(plan), "");
  const auto at = std::ranges::find_if(plan.warnings, [](const std::string& warning) {
    return warning.find("swing out over the edge of the land by up to 0.49 m") != std::string::npos ||
           warning.find("swing out over the edge of the land by up to 0.48 m") != std::string::npos;
  });
  ASSERT_NE(at, plan.warnings.end());
  plan.warnings.erase(at);
  EXPECT_NE(first_warning_at_fault(plan).find("swing out"), std::string::npos)
      << first_warning_at_fault(plan);
}

}  // namespace
}  // namespace tramline::planned_routes
