// What a route claims by the names of its legs, its settings and its figures: each false claim is found.

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <string>

#include "check/route/hand_made_routes.h"
#include "tramline/check/verify.h"

namespace tramline {
namespace {

using namespace testing_plans;

constexpr std::size_t kBackOutLeg = 7, kLastLeg = 8;

bool says(const Plan& plan, const char* what) { return texts(plan).find(what) != std::string::npos; }

/// The machine is turned by so much where a leg begins.
Plan turned_at(std::size_t leg, double by_deg) {
  Plan plan = route_plan();
  Pose& start = plan.route.legs[leg].path.front().start;
  start.heading = towards(start.heading.degrees() + by_deg);
  return plan;
}

TEST(ClaimsOfRoutes, machine_turned_by_one_degree_where_legs_meet) {
  for (const std::size_t leg : {std::size_t{1}, std::size_t{2}, kLastLeg})
    EXPECT_TRUE(says(turned_at(leg, 1), "turns by 1.00° on the spot")) << leg << "\n"
                                                                       << texts(turned_at(leg, 1));
  EXPECT_FALSE(says(turned_at(1, 0.05), "on the spot"));
}

// The works begin where they should; only the machine comes to them from another side.
TEST(ClaimsOfRoutes, turn_that_ends_across_its_track) {
  Plan plan = route_plan();
  SteeredPath& path = plan.route.legs[1].path;
  const Point from = path.front().start.at, to = plan.route.legs[2].path.front().start.at;
  path = {{{from, Heading::from_to(from, to)}, distance(from, to), 0, 0}};
  EXPECT_TRUE(says(timed(plan), "leg 2 (turn) turns by 90.00° on the spot")) << texts(timed(plan));
  EXPECT_TRUE(says(timed(plan), "leg 3 (work) turns by 90.00° on the spot")) << texts(timed(plan));
}

TEST(ClaimsOfRoutes, backing_out_beside_the_works) {
  // By the name of backing out a machine that may not reverse swings off its track.
  Plan plan = route_plan();
  const Pose start = plan.route.legs[kBackOutLeg].path.front().start;
  plan.route.legs[kBackOutLeg].path = {arc_from(start, 12, 1.0 / 30, Gear::kReverse)};
  EXPECT_TRUE(says(plan, "leg 8 (back_out) does not lead along what was driven")) << texts(plan);
  // Along the way that it came, which it may, and beside that: 1/60 m off at the end.
  for (const double curvature : {0.0, 1.0 / 30}) {
    plan = route_plan();
    plan.route.legs.pop_back();
    add_way(plan, LegKind::kTransit, {{1, 0}});
    add_way(plan, LegKind::kBackOut, {{1, curvature}}, Gear::kReverse);
    EXPECT_EQ(says(timed(plan), "leg 10 (back_out) does not lead along what was driven"), curvature > 0)
        << texts(plan);
  }
}

TEST(ClaimsOfRoutes, backing_out_longer_than_the_works) {
  Plan plan = route_plan();
  plan.route.legs.pop_back();
  plan.route.legs[kBackOutLeg].path[0].length_m = 200;
  EXPECT_FALSE(says(timed(plan), "does not lead along")) << texts(plan);
  plan.route.legs[kBackOutLeg].path[0].length_m = 200.5;
  EXPECT_TRUE(says(timed(plan), "does not lead along")) << texts(plan);
}

TEST(ClaimsOfRoutes, route_from_nowhere_or_to_nowhere) {
  Plan plan = route_plan();
  plan.settings.route.end.reset();
  EXPECT_TRUE(says(plan, "leg 9 (transit) ends the route without a gate")) << texts(plan);
  plan = route_plan();
  plan.settings.route.start.reset();
  EXPECT_FALSE(says(plan, "without a gate")) << "it begins at work";
  plan.route.legs.insert(plan.route.legs.begin(), leg(LegKind::kTransit, Gear::kForward, {}));
  plan.route.legs.front().path = {{{{-5, 6}, towards(90)}, 5, 0, 0}};
  EXPECT_TRUE(says(timed(plan), "leg 1 (transit) begins the route without a gate")) << texts(plan);
}

/// The rectangle of route_plan() with a ditch from south to north: two pieces of its first track, 100 m each
/// but for the ditch of 4 m, and the way across.
Plan crossing_route() {
  Plan plan = route_plan();
  plan.route.legs.clear();
  plan.pieces = {{{0, 6}, {98, 6}, 0, 0}, {{102, 6}, {200, 6}, 0, 0}};
  plan.pieces[1].after_crossing = true;
  plan.field.obstacles = {{{box(98, 0, 102, 48), {}}, ObstacleKind::kPassable, "ditch"}};
  add_piece_leg(plan, 0);
  add_way(plan, LegKind::kTransit, {{4, 0}});
  add_piece_leg(plan, 1);
  return timed(plan);
}

TEST(ClaimsOfRoutes, crossing_with_a_bend) {
  EXPECT_FALSE(found(crossing_route()).contains("route order")) << texts(crossing_route());
  Plan plan = crossing_route();
  // A flat curve that is as good as straight, but no straight line.
  SteeredPath& path = plan.route.legs[1].path;
  path = {arc_from(path.front().start, 4, 1e-6, Gear::kForward)};
  EXPECT_TRUE(says(plan, "leg 2 (transit) is not driven straight on")) << texts(plan);
}

TEST(ClaimsOfRoutes, passes_in_another_sequence) {
  // The inner pass, number 2, comes before the outer one.
  Plan plan = passes_plan();
  plan.settings.route.sequence = PassSequence::kOutwards;
  EXPECT_EQ(texts(plan), "");
  plan.settings.route.sequence = PassSequence::kInwards;
  expect_only(plan, "route order");
  EXPECT_TRUE(says(plan, "comes before headland pass 1, though passes go inwards")) << texts(plan);
}

TEST(ClaimsOfRoutes, metres_driven_over_that_are_not_so) {
  const auto with = [](auto change) {
    Plan plan = route_plan();
    change(plan.route);
    return found(plan);
  };
  const Names only{"route driven over"};
  EXPECT_EQ(with([](Route& r) { r.over_worked_m -= 0.5; }), only);
  EXPECT_EQ(with([](Route& r) { r.over_unworked_m += 0.5; }), only);
  EXPECT_EQ(with([](Route& r) { r.over_tracks_m = 0; }), only);
  EXPECT_EQ(with([](Route& r) { r.over_worked_m = std::numeric_limits<double>::quiet_NaN(); }), only);
  // The machine turns outside the field, over land that nothing works.
  EXPECT_EQ(with([](Route& r) { std::swap(r.over_worked_m, r.over_unworked_m); }), only);
}

// Passes come last, so ways between the tracks lead over their land before it is worked.
TEST(ClaimsOfRoutes, land_driven_over_before_it_is_worked) {
  Plan plan = passes_plan();
  EXPECT_GT(plan.route.over_unworked_m, 0);
  std::swap(plan.route.over_worked_m, plan.route.over_unworked_m);
  expect_only(plan, "route driven over");
}

TEST(ClaimsOfRoutes, prices_too_large_to_prove_anything) {
  // Sums that cancel are off by hundreds of seconds.
  Plan plan = route_plan();
  plan.route.proof.node_prices_s.assign(10, 3e18);
  expect_only(plan, "route bound");
  plan.route.proof.node_prices_s.assign(10, std::numeric_limits<double>::quiet_NaN());
  expect_only(plan, "route bound");
}

/// A machine that tows turns by a quarter, r = 6 m, into a track.
Plan towed_route() {
  Plan plan = route_plan();
  plan.machine.turning.implement = Coupling::kTowed;
  plan.machine.turning.drawbar_m = 4;
  plan.pieces.resize(1);
  plan.route.legs.clear();
  const double quarter_m = 3 * std::numbers::pi;
  // The axle is 4 m ahead of the implement where the work begins.
  add(plan, leg(LegKind::kTransit, Gear::kForward,
                {arc_from({{-2, 0}, towards(0)}, quarter_m, -1.0 / 6, Gear::kForward)}));
  add(plan, leg(LegKind::kWork, Gear::kForward, {{{{4, 6}, towards(90)}, 200, 0, 0}}));
  plan.route.legs.back().piece = 0;
  return timed(plan);
}

TEST(ClaimsOfRoutes, towed_implement_beside_its_track) {
  // On a circle of 6 m a drawbar of L = 4 m comes to an angle of asin(4/6), in which the implement's axle
  // would be L sin 41.8° = 2.67 m beside the line; after a quarter it is not there yet.
  Plan plan = towed_route();
  EXPECT_TRUE(says(plan, "leg 1 (transit) leaves the implement")) << texts(plan);
  plan.route.legs[0].lateral_error_m = 4 * 4.0 / 6;
  EXPECT_FALSE(says(plan, "leaves the implement")) << texts(plan);
  plan.route.legs[0].lateral_error_m = 1;
  EXPECT_TRUE(says(plan, "leaves the implement")) << texts(plan);
}

}  // namespace
}  // namespace tramline
