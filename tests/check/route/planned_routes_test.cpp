// Routes that the planner makes hold.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "tramline/check/file/compare_warnings.h"
#include "tramline/check/verify.h"
#include "tramline/planner/plan_field.h"

namespace tramline {
namespace {

Ring box(double min_x, double min_y, double max_x, double max_y) {
  return {{min_x, min_y}, {max_x, min_y}, {max_x, max_y}, {min_x, max_y}};
}

PlanSettings whole_route(int headlands) {
  PlanSettings settings;
  settings.turns = TurnPlanning::kRoute;
  settings.headlands = settings.obstacle_headlands = headlands;
  return settings;
}

Field field_of(Ring outer) {
  Field field;
  field.id = "drawn";
  field.outer = std::move(outer);
  return field;
}

Field l_shape() { return field_of({{0, 0}, {300, 0}, {300, 140}, {160, 140}, {160, 260}, {0, 260}}); }

Field with(Field field, Ring ring, ObstacleKind kind) {
  field.obstacles.push_back({{std::move(ring), {}}, kind, "drawn"});
  return field;
}

Machine machine(double width_m, double radius_m) {
  Machine out;
  out.width_m = width_m;
  out.radius_m = radius_m;
  return out;
}

/// Plans the route, of which all holds, and returns the plan.
Plan expect_route_holds(const Field& field, const Machine& of, const PlanSettings& settings) {
  Plan plan = plan_field(field, of, {}, settings);
  EXPECT_TRUE(plan.route.planned());
  const check::Verdict verdict = check::verify(plan);
  EXPECT_TRUE(verdict.complete);
  for (const check::Violation& v : verdict.violations) ADD_FAILURE() << name(v.rule) << ": " << v.what;
  return plan;
}

TEST(PlannedRoutes, hold_on_a_rectangle) {
  for (const int headlands : {0, 1, 2}) {
    SCOPED_TRACE(headlands);
    expect_route_holds(field_of(box(0, 0, 200, 100)), machine(6, 6), whole_route(headlands));
  }
}

TEST(PlannedRoutes, hold_on_an_l_with_a_pond) {
  const Field field = with(l_shape(), box(60, 60, 90, 85), ObstacleKind::kObstacle);
  for (const bool first : {false, true}) {
    PlanSettings settings = whole_route(2);
    settings.route.passes = first ? PassTime::kFirst : PassTime::kLast;
    expect_route_holds(field, machine(6, 5), settings);
  }
}

/// The first leg along a pass round an obstacle.
std::size_t leg_round_obstacle(const Plan& plan) {
  const auto found = std::ranges::find_if(plan.route.legs, [&](const RouteLeg& leg) {
    return leg.pass && !plan.headland.passes[*leg.pass].obstacles.empty();
  });
  return static_cast<std::size_t>(found - plan.route.legs.begin());
}

/// The same plan, with a leg driven before all others.
Plan with_first(Plan plan, std::size_t leg) {
  const auto at = plan.route.legs.begin() + static_cast<std::ptrdiff_t>(leg);
  std::rotate(plan.route.legs.begin(), at, at + 1);
  return plan;
}

bool finds(const Plan& plan, const std::string& what) {
  const check::Verdict verdict = check::verify(plan);
  return std::ranges::any_of(verdict.violations, [&](const check::Violation& v) {
    return v.rule == check::Rule::kRouteOrder && v.what.find(what) != std::string::npos;
  });
}

// Of two ponds at opposite sides of a field the route can end its tracks at one only. The pass round the
// other it works on its way, once the tracks that end there are done.
TEST(PlannedRoutes, work_the_pass_round_a_pond_among_the_tracks) {
  const Field field = with(with(field_of(box(0, 0, 300, 200)), box(60, 50, 90, 80), ObstacleKind::kObstacle),
                           box(220, 120, 250, 150), ObstacleKind::kObstacle);
  PlanSettings settings = whole_route(2);
  settings.obstacle_headlands = 1;
  settings.avoid = Avoidance::kCut;
  const Plan plan = expect_route_holds(field, machine(6, 6), settings);
  const std::size_t round = leg_round_obstacle(plan);
  const auto& legs = plan.route.legs;
  ASSERT_LT(round, legs.size());
  const auto is_track = [](const RouteLeg& leg) { return leg.piece.has_value(); };
  EXPECT_TRUE(std::any_of(legs.begin() + static_cast<std::ptrdiff_t>(round), legs.end(), is_track));
  EXPECT_FALSE(finds(plan, "works a track"));
  EXPECT_TRUE(finds(with_first(plan, round), "works a track that ends beside headland pass"));
  EXPECT_TRUE(finds(with_first(plan, legs.size() - 1), "works a track after the passes"));
}

TEST(PlannedRoutes, hold_across_a_ditch) {
  const Field field = with(field_of(box(0, 0, 200, 100)), box(90, -5, 95, 105), ObstacleKind::kPassable);
  Field clipped = field;
  clipped.obstacles[0].shape.outer = box(90, 0, 95, 100);
  expect_route_holds(clipped, machine(6, 6), whole_route(2));
}

TEST(PlannedRoutes, hold_between_gates) {
  PlanSettings settings = whole_route(2);
  settings.route.start = Point{0, 40};
  settings.route.end = Point{150, 50};
  expect_route_holds(field_of(box(0, 0, 200, 100)), machine(6, 6), settings);
}

/// The bound of the plan holds, and two parts in a hundred more are refused. Returns the plan.
Plan with_bound_that_holds(Ring outer, const Machine& of, Aim aim = Aim::kCost, int headlands = 0,
                           std::vector<Point> guide = {}) {
  PlanSettings settings = whole_route(headlands);
  settings.boundary = EdgeKind::kHard;
  settings.aim = aim;
  settings.guide = std::move(guide);
  Plan plan = plan_field(field_of(std::move(outer)), of, {}, settings);
  const auto refused = [](const Plan& one) {
    const std::vector<check::Violation> all = check::verify(one).violations;
    return std::any_of(all.begin(), all.end(),
                       [](const check::Violation& v) { return v.rule == check::Rule::kRouteBound; });
  };
  EXPECT_FALSE(refused(plan));
  Plan claims_more = plan;
  claims_more.route.proof.bound_s *= 1.02;
  EXPECT_TRUE(refused(claims_more));
  return plan;
}

// Where the machine backs out of its tracks the bound knows by how much, and the verifier too.
TEST(PlannedRoutes, are_bounded_by_the_sides_that_machines_back_from) {
  const Plan plan = with_bound_that_holds(box(0, 0, 60, 120), machine(6, 6));
  double time_s = 0;
  for (const RouteLeg& leg : plan.route.legs) time_s += leg.time_s;
  EXPECT_GT(plan.route.proof.bound_s, 0.97 * time_s);
  with_bound_that_holds({{0, 0}, {15, 0}, {17, 90}, {15, 180}, {0, 180}, {2, 90}}, machine(6, 6));
  Machine with_tractor = machine(6, 5);
  with_tractor.turning.front_overhang_m = 2;
  with_tractor.turning.vehicle_width_m = 2.5;
  with_tractor.turning.implement_offset_m = 1;
  with_bound_that_holds({{0, 0}, {70, 20}, {70, 80}, {0, 120}}, with_tractor);
}

// Without headlands each turn takes two stops, which the bound counts by their price. To back all along a
// track instead and stop once would take longer.
TEST(PlannedRoutes, are_bounded_with_their_stops_where_these_are_priced) {
  const Plan plan = with_bound_that_holds(box(0, 0, 60, 400), machine(6, 6), Aim::kWholeCost);
  const RouteSums sums = sums_of(plan.route);
  EXPECT_GT(sums.back_outs, 0U);
  EXPECT_GT(plan.route.proof.stop_s, 0);
  EXPECT_GT(plan.route.proof.bound_s, 0.97 * priced_time_s(plan.route));
  EXPECT_GT(plan.route.proof.bound_s, sums.time_s);
}

// The axle is 4 m ahead of a bar as long as half the field is wide: it can neither leave a track nor come to
// the next without a stop, from whatever side the gate lies.
TEST(PlannedRoutes, are_bounded_with_both_stops_of_implements_behind_the_axle) {
  Machine of = machine(12, 1);
  of.turning.implement_offset_m = 4;
  PlanSettings settings = whole_route(0);
  settings.boundary = EdgeKind::kHard;
  settings.aim = Aim::kWholeCost;
  settings.guide = {{0.5, 0}, {0.5, 41}};
  settings.route.end = Point{25, 10};
  const Plan plan = expect_route_holds(field_of(box(0, 0, 25, 41)), of, settings);
  EXPECT_GE(sums_of(plan.route).back_outs, 2U);
  EXPECT_GT(plan.route.proof.bound_s, 2 * plan.route.proof.stop_s);
}

// On a strip of 26 m the machine turns aside from a track along it to the pass along the edge only if it
// backs first, which the bound counts: were it not for that stop it would lie below 0.87 of the route.
TEST(PlannedRoutes, are_bounded_with_the_stop_before_a_closed_pass) {
  const Plan plan =
      with_bound_that_holds(box(0, 0, 26, 100), machine(6, 6), Aim::kWholeCost, 1, {{13, 0}, {13, 100}});
  ASSERT_TRUE(is_closed(plan.headland.passes.front()));
  EXPECT_GT(sums_of(plan.route).back_outs, 0U);
  EXPECT_GT(plan.route.proof.bound_s, 0.97 * priced_time_s(plan.route));
}

/// Two fields of 120 m x 90 m and the lane of 60 m between them.
Field with_lane(double lane_m) {
  return field_of({{0, 0},
                   {120, 0},
                   {120, 30},
                   {180, 30},
                   {180, 0},
                   {300, 0},
                   {300, 90},
                   {180, 90},
                   {180, 30 + lane_m},
                   {120, 30 + lane_m},
                   {120, 90},
                   {0, 90}});
}

// 12 m wide and turning in 8 m, the machine takes 28 m to turn round, and the arms are 25 m wide.
TEST(PlannedRoutes, lead_out_of_two_arms_by_the_way_in) {
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
TEST(PlannedRoutes, lead_through_a_corridor_that_is_too_narrow_to_work) {
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

TEST(PlannedRoutes, hold_on_land_in_two_parts) {
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
TEST(PlannedRoutes, leave_a_part_where_the_next_one_begins) {
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
TEST(PlannedRoutes, hold_where_parts_are_hardly_joined) {
  PlanSettings settings = whole_route(2);
  settings.boundary = EdgeKind::kHard;
  for (const double lane_m : {2.0, 5.5, 5.89, 5.91, 5.99, 6.01}) {
    SCOPED_TRACE(lane_m);
    expect_route_holds(with_lane(lane_m), machine(6, 6), settings);
  }
}

// Where the lane is wide all tracks come before all passes. Were it narrow, the passes on one side would come
// after work on the other.
TEST(PlannedRoutes, finish_one_part_before_the_next) {
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

/// What is wrong with the warnings of a plan, first of all.
std::string found(const Plan& plan) {
  const std::vector<check::Violation> all = check::compare_warnings(plan);
  return all.empty() ? std::string() : all.front().what;
}

TEST(PlannedRoutes, say_into_how_many_parts_the_land_falls) {
  PlanSettings settings = whole_route(2);
  settings.boundary = EdgeKind::kHard;
  Plan plan = plan_field(with_lane(4), machine(6, 6), {}, settings);
  EXPECT_EQ(found(plan), "");
  std::string& said = plan.warnings.back();
  EXPECT_NE(said.find("falls into 2 parts"), std::string::npos) << said;
  said.replace(said.find('2'), 1, "3");
  EXPECT_NE(found(plan).find("other figures"), std::string::npos) << found(plan);
  plan.warnings.pop_back();
  EXPECT_NE(found(plan).find("no warning 'the land falls"), std::string::npos) << found(plan);

  Plan whole = plan_field(with_lane(8), machine(6, 6), {}, settings);
  EXPECT_EQ(found(whole), "");
  whole.warnings.emplace_back("the land falls into 2 parts");
  EXPECT_NE(found(whole).find("without cause"), std::string::npos) << found(whole);
}

Machine with_tractor(Machine of) {
  of.turning.implement_offset_m = 2;
  of.turning.rear_overhang_m = 1;
  of.turning.front_overhang_m = 3;
  of.turning.vehicle_width_m = 2.5;
  of.turning.lift_m = 1;
  of.turning.lower_m = 2;
  return of;
}

TEST(PlannedRoutes, hold_for_machines_that_carry_tow_and_reverse) {
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
TEST(PlannedRoutes, hold_for_machines_that_turn_within_their_drawbar) {
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
TEST(PlannedRoutes, hold_round_closed_passes_with_an_implement_behind_the_axle) {
  for (const double wide_m : {85.0, 121.0})
    expect_route_holds(field_of(box(0, 0, 203, wide_m)), with_tractor(machine(6, 6)), whole_route(3));
}

// Passes next but one are 6 m apart, less the steps between places that planner and verifier look at: by one
// of them more than 1.5 widths, by the other less.
TEST(PlannedRoutes, hold_round_passes_whose_places_are_about_as_far_apart_as_are_looked_at) {
  PlanSettings settings = whole_route(3);
  settings.aim = Aim::kWholeCost;
  expect_route_holds(field_of(box(0, 0, 120, 85)), machine(3, 6), settings);
}

// Its implement works behind the axle: where the axle comes out of the corner of a pass, r = 6 m, the rear
// corner of the bar, 3 m behind and 3 m beside it, is farther from the middle of the arc than the boundary, 6
// m + 3 m.
TEST(PlannedRoutes, say_where_an_implement_swings_out_at_corners) {
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

TEST(PlannedRoutes, hold_with_the_warning_of_corners_that_swing_out) {
  Plan plan = plan_field(field_of(box(0, 0, 200, 100)), with_tractor(machine(6, 6)), {}, whole_route(3));
  EXPECT_EQ(found(plan), "");
  const auto at = std::ranges::find_if(plan.warnings, [](const std::string& warning) {
    return warning.find("swing out over the edge of the land by up to 0.49 m") != std::string::npos ||
           warning.find("swing out over the edge of the land by up to 0.48 m") != std::string::npos;
  });
  ASSERT_NE(at, plan.warnings.end());
  plan.warnings.erase(at);
  EXPECT_NE(found(plan).find("swing out"), std::string::npos) << found(plan);
}

}  // namespace
}  // namespace tramline
