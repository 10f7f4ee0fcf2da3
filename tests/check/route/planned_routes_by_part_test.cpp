// Routes on land that falls into parts, or hardly holds together, hold.

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "check/route/planned_routes.h"
#include "tramline/check/verify.h"
#include "tramline/planner/plan_field.h"

namespace tramline::planned_routes {
namespace {

// 12 m wide and turning in 8 m, the machine takes 28 m to turn round, and the arms are 25 m wide.
TEST(PlannedRoutesByPart, lead_out_of_two_arms_by_the_way_in) {
  const Field field = field_of({{0, 0},
                                {60, 0},
                                {60, -60},
                                {85, -60},
                                {85, 0},
                                {150, 0},
                                {150, 120},
                                {85, 120},
                                {85, 190},
                                {60, 190},
                                {60, 120},
                                {0, 120}});
  for (const int headlands : {1, 2}) {
    SCOPED_TRACE(headlands);
    const Plan plan = expect_route_holds(field, machine(12, 8), whole_route(headlands));
    EXPECT_TRUE(std::ranges::all_of(plan.route.legs, [](const RouteLeg& leg) { return leg.missing_m == 0; }));
    EXPECT_TRUE(std::ranges::any_of(plan.route.legs,
                                    [](const RouteLeg& leg) { return leg.kind == LegKind::kBackOut; }));
  }
}

// Two rooms, and between them a bent corridor 4.5 m wide in which the machine, 6 m wide, works nothing: 0.75
// m of it stick out on either side, and more in the bend. Straight on to the other room it would be 30 m.
TEST(PlannedRoutesByPart, lead_through_a_corridor_that_is_too_narrow_to_work) {
  const Field field = field_of({{0, 0},
                                {60, 0},
                                {60, 27},
                                {120, 27},
                                {120, 120},
                                {150, 120},
                                {150, 180},
                                {90, 180},
                                {90, 120},
                                {115.5, 120},
                                {115.5, 31.5},
                                {60, 31.5},
                                {60, 60},
                                {0, 60}});
  const Plan plan = expect_route_holds(field, machine(6, 6), whole_route(2));
  double missing_m = 0;
  for (const RouteLeg& leg : plan.route.legs) missing_m = std::max(missing_m, leg.missing_m);
  EXPECT_GE(missing_m, 0.75);
  EXPECT_LT(missing_m, 3);
}

TEST(PlannedRoutesByPart, hold_on_land_in_two_parts) {
  PlanSettings settings = whole_route(2);
  settings.boundary = EdgeKind::kHard;
  expect_route_holds(with_lane(4), machine(6, 6), settings);
  settings.route.sequence = PassSequence::kInwards;
  expect_route_holds(with_lane(4), machine(6, 6), settings);
  settings.route.passes = PassTime::kFirst;
  settings.route.start = Point{300, 45};
  settings.route.end = Point{0, 45};
  expect_route_holds(with_lane(4), machine(6, 6), settings);
}

// A strip 13 m wide and 200 m long, in which the machine cannot turn, and through a neck 4 m wide a room. The
// strip has more work and comes first: of its two passes the last one driven ends at the neck.
TEST(PlannedRoutesByPart, leave_a_part_where_the_next_one_begins) {
  const Field field = field_of({{0, -200},
                                {13, -200},
                                {13, 0},
                                {8.5, 0},
                                {8.5, 3},
                                {25, 3},
                                {25, 40},
                                {-12, 40},
                                {-12, 3},
                                {4.5, 3},
                                {4.5, 0},
                                {0, 0}});
  const Plan plan = expect_route_holds(field, machine(6, 6), whole_route(1));
  const auto& legs = plan.route.legs;
  const auto on_to_next = std::ranges::find_if(legs, [](const RouteLeg& leg) { return leg.missing_m > 0; });
  ASSERT_NE(on_to_next, legs.end());
  EXPECT_LT(length(*on_to_next), 30) << "straight on through the neck";
  EXPECT_LT(on_to_next->missing_m, 3);
}

// Up to 0.1 m less than the machine's width the lane is held for wide enough, by the planner and by the
// check.
TEST(PlannedRoutesByPart, hold_where_parts_are_hardly_joined) {
  PlanSettings settings = whole_route(2);
  settings.boundary = EdgeKind::kHard;
  for (const double lane_m : {5.5, 5.89, 5.91, 6.01}) {
    SCOPED_TRACE(lane_m);
    expect_route_holds(with_lane(lane_m), machine(6, 6), settings);
  }
}

// Where the lane is wide all tracks come before all passes. Were it narrow, the passes on one side would come
// after work on the other.
TEST(PlannedRoutesByPart, finish_one_part_before_the_next) {
  PlanSettings settings = whole_route(2);
  settings.boundary = EdgeKind::kHard;
  Plan plan = plan_field(with_lane(8), machine(6, 6), {}, settings);
  const auto goes_back = [&] {
    const std::vector<check::Violation> all = check::verify(plan).violations;
    return std::any_of(all.begin(), all.end(), [](const check::Violation& v) {
      return v.rule == check::Rule::kRouteOrder && v.what.find("goes back to land") != std::string::npos;
    });
  };
  EXPECT_FALSE(goes_back());
  plan.field = with_lane(4);
  EXPECT_TRUE(goes_back());
}

TEST(PlannedRoutesByPart, say_into_how_many_parts_the_land_falls) {
  PlanSettings settings = whole_route(2);
  settings.boundary = EdgeKind::kHard;
  Plan plan = plan_field(with_lane(4), machine(6, 6), {}, settings);
  EXPECT_EQ(first_warning_at_fault(plan), "");
  std::string& said = plan.warnings.back();
  EXPECT_NE(said.find("falls into 2 parts"), std::string::npos) << said;
  said.replace(said.find('2'), 1, "3");
  EXPECT_NE(first_warning_at_fault(plan).find("other figures"), std::string::npos)
      << first_warning_at_fault(plan);
  plan.warnings.pop_back();
  EXPECT_NE(first_warning_at_fault(plan).find("no warning 'the land falls"), std::string::npos)
      << first_warning_at_fault(plan);

  Plan whole = plan_field(with_lane(8), machine(6, 6), {}, settings);
  EXPECT_EQ(first_warning_at_fault(whole), "");
  whole.warnings.emplace_back("the land falls into 2 parts");
  EXPECT_NE(first_warning_at_fault(whole).find("without cause"), std::string::npos)
      << first_warning_at_fault(whole);
}

}  // namespace
}  // namespace tramline::planned_routes
