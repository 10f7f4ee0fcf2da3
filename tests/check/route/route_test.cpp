// Whole routes: one made by hand holds, and each of its rules finds a fault made on purpose.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include "check/route/hand_made_routes.h"
#include "properties/seeds.h"
#include "tramline/check/turning/shortest_ways.h"
#include "tramline/check/verify.h"
#include "tramline/turns/manoeuvres/dubins.h"
#include "tramline/turns/manoeuvres/reeds_shepp.h"

namespace tramline {
namespace {

using namespace testing_plans;

TEST(CheckedRoute, made_by_hand_holds) {
  const Plan plan = route_plan();
  EXPECT_EQ(texts(plan), "");
  EXPECT_TRUE(check::verify(plan).findings.empty());
  // 800 m of work at 2.5 m/s, three half circles and 6 m at 1.5 m/s, 12 m in reverse at 1 m/s, two changes.
  EXPECT_NEAR(time_of(plan), 320 + (18 * std::numbers::pi + 6) / 1.5 + 12 + 6, 1e-9);
}

TEST(CheckedRoute, leaves_no_piece_out_and_drives_none_twice) {
  Plan plan = route_plan();
  plan.route.legs[2].piece = 0;
  expect_found(plan, "route order");
  plan = route_plan();
  plan.route.legs.erase(plan.route.legs.end() - 3, plan.route.legs.end());
  expect_found(timed(plan), "route order");
  expect_found(timed(plan), "route areas");
}

TEST(CheckedRoute, is_there_where_it_was_asked_for) {
  Plan plan = route_plan();
  plan.route = {};
  expect_only(plan, "route order");
  plan.settings.turns = TurnPlanning::kNone;
  EXPECT_EQ(texts(plan), "");
}

TEST(CheckedRoute, keeps_to_the_order_of_the_pieces) {
  Plan plan = route_plan();
  std::swap(plan.pieces[1], plan.pieces[2]);
  std::swap(plan.route.legs[2].piece, plan.route.legs[4].piece);
  EXPECT_NE(texts(plan).find("where it is the turn of piece"), std::string::npos);
}

TEST(CheckedRoute, works_pieces_where_they_are) {
  Plan plan = route_plan();
  for (SteeredStretch& stretch : plan.route.legs[2].path) stretch.start.at.y += 0.01;
  expect_found(plan, "route order");
  // A bend that comes back: both ends are in place.
  plan = route_plan();
  SteeredPath& path = plan.route.legs[0].path;
  const double bend = 1.0 / 500, part = 50;
  path = {arc_from(path.front().start, part, bend, Gear::kForward)};
  for (const double curvature : {-bend, -bend, bend})
    path.push_back(arc_from(end_of(path.back()), part, curvature, Gear::kForward));
  expect_found(timed(plan), "route order");
}

TEST(CheckedRoute, with_passes_made_by_hand_holds) { EXPECT_EQ(texts(passes_plan()), ""); }

TEST(CheckedRoute, drives_each_pass_once_whole_and_in_place) {
  const Plan sound = passes_plan();
  const std::size_t open = sound.route.legs.size() - 3, closed = sound.route.legs.size() - 1;
  ASSERT_EQ(sound.route.legs[open].pass, 1U);
  ASSERT_EQ(sound.route.legs[closed].pass, 0U);
  Plan plan = sound;
  plan.route.legs.resize(closed - 1);
  EXPECT_NE(texts(plan).find("headland pass 1 is not driven"), std::string::npos) << texts(plan);
  expect_found(plan, "route areas");
  plan = sound;
  plan.route.legs.push_back(plan.route.legs.back());
  EXPECT_NE(texts(plan).find("shorter than what is driven of it"), std::string::npos) << texts(plan);
  for (const std::size_t pass : {open, closed}) {
    plan = sound;
    plan.route.legs[pass].path.pop_back();
    EXPECT_NE(texts(timed(plan)).find("shorter than what is driven of it"), std::string::npos);
    plan = sound;
    for (SteeredStretch& stretch : plan.route.legs[pass].path) stretch.start.at.x += 0.01;
    EXPECT_NE(texts(plan).find("off its place"), std::string::npos) << texts(plan);
  }
}

TEST(CheckedRoute, leaves_no_pass_before_it_is_worked) {
  Plan plan = passes_plan();
  RouteLeg half = plan.route.legs.back();
  RouteLeg& first = plan.route.legs.back();
  half.path.erase(half.path.begin(), half.path.begin() + 2);
  first.path.resize(2);
  EXPECT_EQ(texts(plan).find("taken up again"), std::string::npos);
  add_shortest(plan, half.path.front().start);
  add_way(plan, LegKind::kTransit, {{0, 0}});
  add(plan, half);
  EXPECT_NE(texts(timed(plan)).find("taken up again"), std::string::npos) << texts(plan);
}

TEST(CheckedRoute, interrupts_passes_on_passable_obstacles_only) {
  Plan plan = passes_plan();
  // Off along a stretch of 2 m and more on the open land.
  RouteLeg rest = plan.route.legs.back();
  RouteLeg& off = plan.route.legs.back();
  rest.path.erase(rest.path.begin());
  off.path.resize(1);
  off.kind = LegKind::kTransit;
  off.work = false;
  add(plan, rest);
  EXPECT_NE(texts(timed(plan)).find("has the work off along"), std::string::npos) << texts(plan);
}

TEST(CheckedRoute, drives_passes_when_the_settings_ask_for_it) {
  Plan plan = passes_plan();
  plan.settings.route.passes = PassTime::kFirst;
  expect_only(plan, "route order");
}

TEST(CheckedRoute, has_the_work_on_along_pieces_only) {
  Plan plan = route_plan();
  plan.route.legs[1].work = true;
  expect_only(timed(plan), "route order");
  plan = route_plan();
  plan.route.legs[2].work = false;
  expect_found(timed(plan), "route order");
}

TEST(CheckedRoute, is_joined_in_place_and_heading) {
  Plan plan = route_plan();
  plan.route.legs[1].path.front().start.at.y += 0.01;
  expect_only(plan, "route legs");
  plan = route_plan();
  Pose& start = plan.route.legs[1].path.front().start;
  start.heading = towards(start.heading.degrees() + 2);
  EXPECT_NE(texts(plan).find("on the spot"), std::string::npos);
}

TEST(CheckedRoute, begins_and_ends_at_its_gates) {
  for (const bool at_start : {true, false}) {
    Plan plan = route_plan();
    std::optional<Point>& gate = at_start ? plan.settings.route.start : plan.settings.route.end;
    gate = *gate + Point{0.5, 0};
    // The gate is on the land, where the machine has room.
    expect_only(plan, "route legs");
  }
}

TEST(CheckedRoute, turns_no_tighter_than_the_machine) {
  Plan plan = route_plan();
  plan.machine.radius_m = 6.5;
  EXPECT_NE(texts(plan).find("has a radius of 6.00 m"), std::string::npos) << texts(plan);
}

TEST(CheckedRoute, steers_no_faster_than_the_machine) {
  Plan plan = route_plan();
  plan.machine.turning.steering_time_s = 2;
  EXPECT_EQ(texts(plan), "") << "a machine that stands may steer";
  // From left to right at once.
  SteeredPath& path = plan.route.legs[5].path;
  path = {arc_from(path.front().start, 1, 1.0 / 6, Gear::kForward)};
  path.push_back(arc_from(end_of(path.back()), 1, -1.0 / 6, Gear::kForward));
  EXPECT_NE(texts(timed(plan)).find("jump of curvature"), std::string::npos);
}

TEST(CheckedRoute, reverses_only_where_it_may) {
  Plan plan = route_plan();
  RouteLeg& back = plan.route.legs[7];
  ASSERT_EQ(back.gear, Gear::kReverse);
  back.kind = LegKind::kTransit;
  expect_only(plan, "route legs");
  plan.machine.turning.reverse = true;
  EXPECT_EQ(texts(plan), "");
  plan.machine.turning.implement = Coupling::kTowed;
  plan.machine.turning.drawbar_m = 3;
  EXPECT_NE(texts(plan).find("with a drawbar in tow"), std::string::npos);
}

TEST(CheckedRoute, changes_gear_between_legs_only) {
  Plan plan = route_plan();
  RouteLeg& back = plan.route.legs[7];
  back.path.insert(back.path.end(), plan.route.legs[8].path.begin(), plan.route.legs[8].path.end());
  plan.route.legs.pop_back();
  EXPECT_NE(texts(timed(plan)).find("changes gear on its way"), std::string::npos);
}

TEST(CheckedRoute, takes_the_time_of_its_lengths_speeds_and_gears) {
  for (const std::size_t i : {0U, 1U, 7U, 8U}) {
    Plan plan = route_plan();
    plan.route.legs[i].time_s += 0.01;
    expect_only(plan, "route legs");
  }
}

TEST(CheckedRoute, stays_on_the_land) {
  Plan plan = route_plan();
  plan.settings.boundary = EdgeKind::kHard;
  // At the apex of a half circle of 6 m the bar's outer end is 6 m + 6 m from the end of the track.
  EXPECT_NE(texts(plan).find("leg 2 (turn) leaves the land by 12.00 m"), std::string::npos) << texts(plan);
  for (const std::size_t i : {1U, 3U, 5U}) plan.route.legs[i].missing_m = 12;
  EXPECT_EQ(texts(plan), "");
  EXPECT_EQ(check::verify(plan).findings.size(), 3U);
  plan.route.legs[3].missing_m = 11.9;
  expect_only(plan, "route room");
}

TEST(CheckedRoute, keeps_off_obstacles_where_it_turns) {
  // On a larger field there is a ditch where the machine turns; that other rules find more does not matter.
  Plan plan = route_plan();
  plan.field.outer = box(-50, -10, 260, 60);
  plan.field.obstacles = {{{box(210, 10, 214, 14), {}}, ObstacleKind::kPassable, "ditch"}};
  const check::Verdict verdict = check::verify(plan);
  EXPECT_TRUE(std::any_of(verdict.violations.begin(), verdict.violations.end(),
                          [](const check::Violation& v) {
                            return v.rule == check::Rule::kRouteRoom && v.what.starts_with("leg 2 (turn)");
                          }))
      << texts(plan);
  plan.route.legs[1].kind = LegKind::kTransit;
  EXPECT_FALSE(found(plan).contains("route room")) << texts(plan);
}

constexpr double kWork_s = 320;
const double kHalfCircle_s = 6 * std::numbers::pi / 1.5;

/// The bound is what is stated, and no more.
void expect_proves(Plan plan, double bound_s) {
  plan.route.proof.bound_s = bound_s;
  EXPECT_EQ(texts(plan), "");
  plan.route.proof.bound_s = bound_s + 0.01;
  expect_only(plan, "route bound");
}

TEST(CheckedRoute, has_a_bound_that_its_prices_prove) {
  // Prices of 0: the tree joins the first gate to the first track (0 m) and to the second (12 m), the other
  // one to the last track (6 m) and to the third (6 m along, 12 m across), and two tracks by a half circle.
  const Plan plan = route_plan();
  expect_proves(plan, kWork_s + (12 + 6 + std::hypot(6, 12)) / 1.5 + kHalfCircle_s);
}

TEST(CheckedRoute, prices_change_what_is_proven) {
  // Where gates are dear, each is joined once: three half circles, 0 m and 6 m.
  Plan plan = route_plan();
  std::vector<double>& prices = plan.route.proof.node_prices_s;
  prices[8] = prices[9] = 100;
  expect_proves(plan, kWork_s + 3 * kHalfCircle_s + 4);
  // The start of the first track at 20 s: its gate is joined to the second track instead, by 12 m.
  prices[0] = 20;
  expect_proves(plan, kWork_s + 3 * kHalfCircle_s + 4 + 12 / 1.5 - 20);
}

TEST(CheckedRoute, has_a_bound_below_its_time_and_a_price_for_each_node) {
  Plan plan = route_plan();
  plan.route.proof.bound_s = time_of(plan) + 1;
  EXPECT_NE(texts(plan).find("less than its bound"), std::string::npos);
  plan = route_plan();
  plan.route.proof.node_prices_s.pop_back();
  expect_only(plan, "route bound");
}

// The route backs out once: the stop counts in the route as well as in its bound.
TEST(CheckedRoute, counts_stops_as_its_bound_does) {
  Plan plan = route_plan();
  plan.route.proof.stop_s = 100;
  plan.route.proof.bound_s = time_of(plan) + 99;
  EXPECT_EQ(texts(plan).find("less than its bound"), std::string::npos);
  plan.route.proof.bound_s = time_of(plan) + 101;
  EXPECT_NE(texts(plan).find("less than its bound"), std::string::npos);
  for (const double stop_s : {-1.0, 901.0, std::nan("")}) {
    plan = route_plan();
    plan.route.proof.stop_s = stop_s;
    expect_only(plan, "route bound");
  }
}

// Independent roads to the same lengths.
TEST(CheckedRoute, shortest_ways_equal_those_of_manoeuvres) {
  for (int seed = 0; seed < 100000; ++seed) {
    testing::SeededRandom random(seed);
    const auto number = [&random](double least, double most) {
      return std::uniform_real_distribution<double>(least, most)(random);
    };
    const double radius = number(0.5, 12), reach = std::pow(10, number(-1, 2));
    const Pose from{{number(-50, 50), number(-50, 50)}, towards(number(0, 360))};
    const Pose to{from.at + Point{number(-reach, reach), number(-reach, reach)}, towards(number(0, 360))};
    ASSERT_NEAR(check::least_forward_m(from, to, radius), dubins_length(from, to, radius), 1e-6) << seed;
    ASSERT_NEAR(check::least_with_reversing_m(from, to, radius), reeds_shepp_length(from, to, radius), 1e-6)
        << seed;
  }
}

TEST(CheckedRoute, shortest_ways_of_poses_in_line_are_straight) {
  const Pose from{{3, 4}, towards(37)};
  const Pose ahead{from.at + 25 * from.heading.unit(), from.heading};
  EXPECT_NEAR(check::least_forward_m(from, ahead, 6), 25, 1e-9);
  EXPECT_NEAR(check::least_with_reversing_m(ahead, from, 6), 25, 1e-9);
  EXPECT_NEAR(check::least_forward_m(from, from, 6), 0, 1e-6);
  // Tracks 2r apart: half a circle.
  const Pose back{from.at + 12 * left_of(from.heading.unit()), towards(37 + 180)};
  EXPECT_NEAR(check::least_forward_m(from, back, 6), 6 * std::numbers::pi, 1e-6);
}

}  // namespace
}  // namespace tramline
