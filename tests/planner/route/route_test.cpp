// Whole routes: what is driven, in which order, joined end to end, on the land, and no longer than it has to
// be.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <random>
#include <string>
#include <vector>

#include "planner/route/sound_route.h"
#include "properties/seeds.h"
#include "tramline/geometry/error.h"
#include "tramline/planner/plan_field.h"

namespace tramline {
namespace {

using testing::box;
using testing::end_of;
using testing::expect_all_driven;
using testing::expect_joined;
using testing::expect_on_the_land;
using testing::expect_sound;
using testing::for_each_seed;
using testing::random_field;
using testing::rectangle;
using testing::whole_route;

Field with_obstacle(Field field, const Ring& ring, ObstacleKind kind) {
  field.obstacles.push_back({{ring, {}}, kind, "drawn"});
  return field;
}

// Ten tracks 12 m apart, r = 6: every turn is half a circle, 18.85 m, which no way between two tracks can
// beat. The machine turns beyond the soft edge.
TEST(Route, OfARectangleIsTheClosedForm) {
  const Plan plan = plan_field(rectangle(400, 120), {"", 12, 6}, {}, whole_route(0));
  ASSERT_EQ(plan.pieces.size(), 10U);
  expect_sound(plan);
  const RouteSums sums = sums_of(plan.route);
  EXPECT_NEAR(sums.turning_m, 9 * std::numbers::pi * 6, 1e-6);
  EXPECT_EQ(sums.transit_m, 0);
  EXPECT_NEAR(sums.working_m, 10 * 400, 1e-6);
  EXPECT_NEAR(sums.time_s, 4000 / 2.5 + 9 * std::numbers::pi * 6 / 1.5, 1e-6);
  EXPECT_NEAR(plan.route.proof.bound_s, sums.time_s, 1e-3 * sums.time_s);
}

// Tracks 3 m apart, r = 6: from each to the next it takes an omega of r(π + 4 acos((r + s/2)/2r)) = 40.35 m.
TEST(Route, OfNeighbouringTracksIsOmegas) {
  PlanSettings settings = whole_route(0);
  settings.route.order = TrackOrder::kBySpacing;
  const Plan plan = plan_field(rectangle(400, 60), {"", 3, 6}, {}, settings);
  ASSERT_EQ(plan.pieces.size(), 20U);
  expect_sound(plan);
  const double omega_m = 6 * (std::numbers::pi + 4 * std::acos(7.5 / 12));
  EXPECT_NEAR(sums_of(plan.route).turning_m, 19 * omega_m, 1e-6);
}

TEST(Route, InTheBestOrderSavesAThirdOfTheWayBetweenNarrowTracks) {
  PlanSettings adjacent = whole_route(6);
  adjacent.route.order = TrackOrder::kBySpacing;
  const Field field = rectangle(400, 160);
  const Plan before = plan_field(field, {"", 3, 6}, {}, adjacent);
  const Plan best = plan_field(field, {"", 3, 6}, {}, whole_route(6));
  expect_sound(best);
  expect_on_the_land(best);
  ASSERT_GE(best.pieces.size(), 12U);
  EXPECT_LT(sums_of(best.route).not_working_m(), 0.7 * sums_of(before.route).not_working_m());
  EXPECT_LT(gap(sums_of(best.route).time_s, best.route.proof.bound_s), 0.02);
}

TEST(Route, WorksHeadlandPassesFirstOrLast) {
  for (const PassTime time : {PassTime::kFirst, PassTime::kLast}) {
    PlanSettings settings = whole_route(2);
    settings.route.passes = time;
    settings.route.sequence = PassSequence::kInwards;
    const Plan plan = plan_field(rectangle(300, 150), {"", 6, 5}, {}, settings);
    expect_sound(plan);
    expect_on_the_land(plan);
    std::vector<LegKind> work;
    std::vector<int> numbers;
    for (const RouteLeg& leg : plan.route.legs) {
      if (leg.work) work.push_back(leg.kind);
      if (leg.kind == LegKind::kHeadland) numbers.push_back(plan.headland.passes[*leg.pass].number);
    }
    EXPECT_EQ(numbers, (std::vector<int>{1, 2}));
    EXPECT_EQ(work.front() == LegKind::kHeadland, time == PassTime::kFirst);
    EXPECT_EQ(work.back() == LegKind::kHeadland, time == PassTime::kLast);
    EXPECT_TRUE(std::is_sorted(work.begin(), work.end()) || std::is_sorted(work.rbegin(), work.rend()));
  }
}

// Tracks end at a wall across the field, without headland: the machine gets away in reverse alone.
TEST(Route, BacksOutOfDeadEnds) {
  const Field field = with_obstacle(rectangle(300, 120), box(150, 6, 151, 114), ObstacleKind::kObstacle);
  PlanSettings settings = whole_route(0);
  settings.boundary = EdgeKind::kSoft;
  settings.guide = {{0, 60}, {300, 60}};
  const Plan plan = plan_field(field, {"", 6, 5}, {}, settings);
  expect_sound(plan);
  expect_on_the_land(plan);
  ASSERT_GT(plan.tally.stops, 0);
  EXPECT_TRUE(std::ranges::any_of(plan.route.legs, [](const RouteLeg& leg) {
    return leg.kind == LegKind::kBackOut && leg.gear == Gear::kReverse;
  }));
  EXPECT_EQ(legs_without_room(plan.route, plan.machine), 0U);
}

/// Two fields of 120 m x 90 m and the lane of 60 m between them.
Field with_lane(double lane_m) {
  Field field;
  field.id = "with a lane";
  field.outer = {{0, 0},    {120, 0},  {120, 30},          {180, 30},          {180, 0},  {300, 0},
                 {300, 90}, {180, 90}, {180, 30 + lane_m}, {120, 30 + lane_m}, {120, 90}, {0, 90}};
  return field;
}

/// How often work right of the lane follows work left of it, or the other way round.
int changes_of_side(const Plan& plan) {
  int out = 0;
  std::optional<bool> right;
  for (const RouteLeg& leg : plan.route.legs) {
    if (!leg.work) continue;
    const bool is_right = leg.path.front().start.at.x > 150;
    if (right && *right != is_right) ++out;
    right = is_right;
  }
  return out;
}

// Through a lane of 4 m no machine of 6 m drives: it works all of one side, tracks and passes, leaves the
// land once, and works the other side.
TEST(Route, FinishesOnePartOfTheLandBeforeTheNext) {
  for (const PassTime passes : {PassTime::kLast, PassTime::kFirst}) {
    PlanSettings settings = whole_route(2);
    settings.boundary = EdgeKind::kHard;
    settings.route.passes = passes;
    const Plan plan = plan_field(with_lane(4), {"", 6, 6}, {}, settings);
    expect_sound(plan);
    EXPECT_EQ(changes_of_side(plan), 1);
    EXPECT_EQ(legs_without_room(plan.route, plan.machine), 1U);
  }
}

TEST(Route, EndsOnThePartOfTheLandWithItsGate) {
  for (const bool left : {false, true}) {
    PlanSettings settings = whole_route(2);
    settings.boundary = EdgeKind::kHard;
    settings.route.end = left ? Point{0, 45} : Point{300, 45};
    const Plan plan = plan_field(with_lane(4), {"", 6, 6}, {}, settings);
    expect_sound(plan);
    EXPECT_EQ(changes_of_side(plan), 1);
    EXPECT_EQ(legs_without_room(plan.route, plan.machine), 1U);
    EXPECT_EQ(end_of(plan.route.legs.back()).at.x < 150, left);
  }
}

// Through 8 m it drives: all passes come after all tracks.
TEST(Route, WorksLandThatIsJoinedAsOne) {
  PlanSettings settings = whole_route(2);
  settings.boundary = EdgeKind::kHard;
  const Plan plan = plan_field(with_lane(8), {"", 6, 6}, {}, settings);
  expect_sound(plan);
  bool passes = false;
  for (const RouteLeg& leg : plan.route.legs) {
    passes = passes || leg.pass;
    EXPECT_FALSE(passes && leg.piece);
  }
}

TEST(Route, CrossesPassableStripsStraightOn) {
  const Field field = with_obstacle(rectangle(300, 120), box(148, -5, 152, 125), ObstacleKind::kPassable);
  PlanSettings settings = whole_route(2);
  settings.guide = {{0, 60}, {300, 60}};
  const Plan plan = plan_field(field, {"", 6, 5}, {}, settings);
  expect_joined(plan);
  expect_all_driven(plan);
  ASSERT_GT(plan.tally.crossings, 0);
  std::size_t crossings = 0;
  for (std::size_t i = 1; i + 1 < plan.route.legs.size(); ++i) {
    const RouteLeg& leg = plan.route.legs[i];
    if (leg.kind == LegKind::kTransit && plan.route.legs[i - 1].kind == LegKind::kWork &&
        plan.route.legs[i + 1].kind == LegKind::kWork && std::abs(length(leg) - 4) < 1e-6)
      ++crossings;
  }
  EXPECT_EQ(crossings, static_cast<std::size_t>(plan.tally.crossings));
}

// A sprayer that works 5 m behind its axle and needs 4 m to lift and lower.
TEST(Route, JoinsLegsOfImplementsBehindTheAxle) {
  Machine machine{"", 6, 5};
  machine.turning.implement_offset_m = 5;
  machine.turning.lift_m = 2;
  machine.turning.lower_m = 4;
  const Plan plan = plan_field(rectangle(300, 150), machine, {}, whole_route(4));
  expect_sound(plan);
  for (const RouteLeg& leg : plan.route.legs) {
    // On the arcs of the outermost passes, r = 5, the outer end of the bar, 3 m to the side and 5 m behind,
    // is on a circle of √(8² + 5²) = 9.43 m, 1.43 m beyond the swath, which touches the edge.
    if (leg.missing_m > 0) {
      EXPECT_EQ(leg.kind, LegKind::kHeadland);
    }
    EXPECT_LT(leg.missing_m, 1.5);
  }
  EXPECT_TRUE(std::ranges::any_of(plan.route.legs, [](const RouteLeg& leg) { return leg.missing_m > 0; }));
  EXPECT_EQ(legs_without_room(plan.route, plan.machine), 0U);
}

// Its rear corners swing out over the edge wherever it turns off the outermost pass, so nothing may follow
// that one. On long land the pass of 6.6 km swings as far in its corners as a short one: r = w = 6 m, 3 m
// behind the axle, √(9² + 3²) − 9.
TEST(Route, WorksThePassAtTheEdgeLastWhereItCannotBeLeft) {
  Machine machine{"", 6, 6};
  machine.turning.implement_offset_m = 2;
  machine.turning.rear_overhang_m = 1;
  for (const double long_m : {203.0, 3200.0}) {
    PlanSettings settings = whole_route(3);
    settings.boundary = EdgeKind::kHard;
    settings.aim = Aim::kWholeCost;
    const Plan plan = plan_field(rectangle(long_m, 121), machine, {}, settings);
    expect_sound(plan);
    EXPECT_EQ(legs_without_room(plan.route, plan.machine), 0U);
    const RouteLeg& last = plan.route.legs.back();
    ASSERT_TRUE(last.pass.has_value());
    EXPECT_EQ(plan.headland.passes[*last.pass].number, 1);
    EXPECT_NEAR(last.missing_m, std::sqrt(90) - 9, 0.01);
  }
}

TEST(Route, IsTheSameForAnyNumberOfThreads) {
  const Field field = with_obstacle(rectangle(300, 150), box(140, 60, 160, 80), ObstacleKind::kObstacle);
  const Plan one = plan_field(field, {"", 3, 6}, {}, whole_route(2), 1);
  const Plan two = plan_field(field, {"", 3, 6}, {}, whole_route(2), 2);
  ASSERT_EQ(one.route.legs.size(), two.route.legs.size());
  for (std::size_t i = 0; i < one.route.legs.size(); ++i) {
    EXPECT_EQ(one.route.legs[i].time_s, two.route.legs[i].time_s);
    EXPECT_EQ(one.route.legs[i].path.front().start.at, two.route.legs[i].path.front().start.at);
  }
  EXPECT_EQ(one.route.proof.node_prices_s, two.route.proof.node_prices_s);
}

// What legs with the work off lead over is worked before them or after them, or it is not worked at all.
TEST(Route, TellsWorkedFromUnworkedLand) {
  PlanSettings settings = whole_route(3);
  const Field field = rectangle(300, 150);
  settings.route.passes = PassTime::kFirst;
  const Plan first = plan_field(field, {"", 6, 5}, {}, settings);
  settings.route.passes = PassTime::kLast;
  const Plan last = plan_field(field, {"", 6, 5}, {}, settings);
  // Turns lie on the headland: worked before where passes come first, later where they come last.
  EXPECT_GT(first.route.over_worked_m, 0.8 * sums_of(first.route).not_working_m());
  EXPECT_GT(last.route.over_unworked_m, 0.5 * sums_of(last.route).not_working_m());
  EXPECT_LE(last.route.over_worked_m + last.route.over_unworked_m,
            sums_of(last.route).not_working_m() + 1e-6);
}

/// A field with a spur as wide as the machine.
Field field_with_spur(double spur_m) {
  Field out;
  out.id = "spur";
  out.outer = {{0, 0}, {100 + spur_m, 0}, {100 + spur_m, 6}, {100, 6}, {100, 100}, {0, 100}};
  return out;
}

PlanSettings cheapest_within_boundary() {
  PlanSettings out = whole_route(0);
  out.headland_rule = HeadlandRule::kTurns;
  out.boundary = EdgeKind::kHard;
  out.aim = Aim::kWholeCost;
  return out;
}

// Between gates in the field a spur can only be left in reverse, until the bar has come out of it.
TEST(Route, BacksOutOfASpurByTheWayItCameIn) {
  for (const double spur_m : {40.0, 120.0}) {
    PlanSettings settings = cheapest_within_boundary();
    settings.route.start = settings.route.end = Point{50, 94};
    settings.route.corners = PassCorners::kRound;
    const Plan plan = plan_field(field_with_spur(spur_m), {"", 6, 6}, {}, settings);
    expect_sound(plan);
    const RouteSums sums = sums_of(plan.route);
    EXPECT_EQ(legs_without_room(plan.route, plan.machine), 0U);
    EXPECT_GE(sums.reverse_m, spur_m);
    EXPECT_LE(sums.reverse_m, spur_m + 60);
  }
}

// Where passes come last and there is no gate, nothing is left to do once the spur is worked.
TEST(Route, EndsInASpurThatItNeedNotLeave) {
  for (const double spur_m : {40.0, 120.0}) {
    const Plan plan = plan_field(field_with_spur(spur_m), {"", 6, 6}, {}, cheapest_within_boundary());
    expect_sound(plan);
    EXPECT_EQ(legs_without_room(plan.route, plan.machine), 0U);
    EXPECT_LT(sums_of(plan.route).reverse_m, spur_m);
    EXPECT_GT(end_of(plan.route.legs.back().path.back()).at.x, 100);
  }
}

// Fields with obstacles, with and without headlands: every piece and pass once, joined, on the land.
TEST(RouteProperties, RandomFieldsAreDrivenWhole) {
  for_each_seed(4, [](std::mt19937_64& random, int number) {
    const Field field = random_field(random, 3);
    PlanSettings settings = whole_route(number % 4);
    if (number % 5 == 0) settings.route.passes = PassTime::kFirst;
    Machine machine{"", number % 2 == 0 ? 6.0 : 3.0, 5};
    machine.turning.reverse = number % 3 == 0;
    const auto corner = [&] {
      return field.outer[std::uniform_int_distribution<std::size_t>(0, field.outer.size() - 1)(random)];
    };
    if (number % 3 == 1) settings.route.start = corner();
    if (number % 4 == 1) settings.route.end = corner();
    try {
      const Plan plan = plan_field(field, machine, {}, settings);
      if (!plan.route.planned()) return;
      expect_sound(plan);
      expect_on_the_land(plan);
    } catch (const Error& error) {
      ASSERT_EQ(error.kind(), ErrorKind::kBadInput) << error.what();
    }
  });
}

// Three passes of 200 m side by side fill a strip 9 m wide, on which a machine of r = 6 m does not turn: it
// works one, backs to where it came from, works the next, and backs again. It needs some metres to get from
// one to the other.
TEST(Route, SaysThatItBacksFarWhereNothingTurns) {
  PlanSettings settings = whole_route(0);
  settings.headland_rule = HeadlandRule::kTurns;
  settings.boundary = EdgeKind::kHard;
  settings.aim = Aim::kWholeCost;
  const auto said = [&](double wide_m) -> std::optional<double> {
    const Plan plan = plan_field(rectangle(200, wide_m), {"", 3, 6}, {}, settings);
    for (const std::string& warning : plan.warnings)
      if (warning.find("m of the route") != std::string::npos) return std::stod(warning);
    return std::nullopt;
  };
  const std::optional<double> backed_m = said(9);
  ASSERT_TRUE(backed_m);
  EXPECT_NEAR(*backed_m, 400, 40);
  EXPECT_FALSE(said(60));
}

}  // namespace
}  // namespace tramline
