// What a whole route costs, by hand, and that the planner takes the cheaper of two.

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "tramline/model/rate_values.h"
#include "tramline/planner/plan_field.h"
#include "tramline/planner/whole/route_floor.h"
#include "tramline/planner/whole/track_prices.h"
#include "tramline/route/turning/turning_land.h"

namespace tramline {
namespace {

Field bare_field(double width_m, double height_m) {
  Field field;
  field.id = "bare";
  field.outer = {{0, 0}, {width_m, 0}, {width_m, height_m}, {0, height_m}};
  return field;
}

RouteLeg timed(LegKind kind, bool work, double time_s) {
  RouteLeg out;
  out.kind = kind;
  out.work = work;
  out.time_s = time_s;
  return out;
}

PlanSettings automatic_headlands() {
  PlanSettings settings;
  settings.turns = TurnPlanning::kRoute;
  settings.headland_rule = HeadlandRule::kTurns;
  return settings;
}

// Half an hour at work, a quarter of an hour on the headland, 10 minutes of turns and 5 of transit: 1 h.
// Fuel 20 l/h · (45 + 15/2) min = 17.5 l. 200 m² twice with 4 sections: 200/10,000 · 100/4 = 0.50 €; 50 m²
// missed at 1,000 €/ha: 5 €. One leg backs out: 7 €. 100 m over crop: 100 · 1.2/10,000 · 1,000 = 12 €.
TEST(WholeCost, IsWhatIsCalculatedByHand) {
  Plan plan;
  plan.field = bare_field(100, 100);
  plan.body = {{plan.field.outer, {}}};
  plan.machine.width_m = 3;
  plan.machine.rates = {Operation::kSpraying, 60, 20, 1.5, 4, 100, 1000, 7};
  plan.tally.overlap_m2 = 200;
  plan.tally.uncovered_m2 = 50;
  plan.route.over_tracks_m = 100;
  plan.route.legs = {timed(LegKind::kWork, true, 1800), timed(LegKind::kTurn, false, 400),
                     timed(LegKind::kHeadland, true, 900), timed(LegKind::kBackOut, false, 200),
                     timed(LegKind::kTransit, false, 300)};
  const WholeCost cost = whole_cost(plan);
  EXPECT_DOUBLE_EQ(cost.time_s(), 3600);
  EXPECT_DOUBLE_EQ(cost.turning_s, 600);
  EXPECT_DOUBLE_EQ(cost.not_working_s(), 900);
  EXPECT_DOUBLE_EQ(cost.hours, 60);
  EXPECT_DOUBLE_EQ(cost.fuel_l, 17.5);
  EXPECT_DOUBLE_EQ(cost.fuel, 26.25);
  EXPECT_DOUBLE_EQ(cost.overlap, 0.5);
  EXPECT_DOUBLE_EQ(cost.missed, 5);
  EXPECT_DOUBLE_EQ(cost.stops, 7);
  EXPECT_DOUBLE_EQ(cost.driven_over, 12);
  EXPECT_DOUBLE_EQ(cost.without_room, 0);
  EXPECT_DOUBLE_EQ(cost.euros(), 60 + 26.25 + 0.5 + 5 + 7 + 12);
  // 9,950 m² in an hour, and 3 m · 2.5 m/s · 3,600 s = 27,000 m² without a turn.
  EXPECT_NEAR(cost.field_efficiency, 9950.0 / 27000, 1e-12);
}

// 60 €/h and half of 20 l/h at 1.50 €/l are 75 € an hour with the work off: 7 € are 336 s of it.
TEST(StopSeconds, AreThePriceOfAStopInTimeWithTheWorkOff) {
  Rates rates{Operation::kSpraying, 60, 20, 1.5, 4, 100, 1000, 7};
  EXPECT_DOUBLE_EQ(stop_seconds(rates), 336);
  rates.price_per_stop = 100;
  EXPECT_EQ(stop_seconds(rates), kLongestStop_s);
  rates.price_per_hour = rates.fuel_price = 0;  // time costs nothing
  EXPECT_EQ(stop_seconds(rates), 0);
}

// At 75 € an hour 1.2 m of a crop of 1,000 €/ha, 0.12 €, are 5.76 s.
TEST(DrivenOverSeconds, AreTheCropUnderTheWheelsInTimeWithTheWorkOff) {
  Rates rates{Operation::kSpraying, 60, 20, 1.5, 4, 100, 1000, 7};
  EXPECT_DOUBLE_EQ(driven_over_seconds_per_m(rates), 5.76);
  rates.operation = Operation::kSeeding;  // nothing stands yet
  EXPECT_EQ(driven_over_seconds_per_m(rates), 0);
  rates.operation = Operation::kSpraying;
  rates.price_per_hour = rates.fuel_price = 0;  // time costs nothing
  EXPECT_EQ(driven_over_seconds_per_m(rates), 0);
}

// Two legs that leave the land count 50 € each, which is not time.
TEST(WholeCost, CountsLegsWithoutRoom) {
  Plan plan;
  plan.field = bare_field(100, 100);
  plan.body = {{plan.field.outer, {}}};
  plan.route.legs = {timed(LegKind::kWork, true, 1800), timed(LegKind::kTurn, false, 400),
                     timed(LegKind::kTransit, false, 300)};
  const WholeCost with_room = whole_cost(plan);
  plan.route.legs[1].missing_m = 0.1;
  plan.route.legs[2].missing_m = 3;
  const WholeCost without = whole_cost(plan);
  EXPECT_DOUBLE_EQ(without.without_room, 100);
  EXPECT_DOUBLE_EQ(without.euros(), with_room.euros() + 100);
  EXPECT_DOUBLE_EQ(without.time_s(), with_room.time_s());
}

// r = 6 m, w = 6 m, the bar from 2 m to 3 m behind the axle: its rear corner swings out to √(9² + 3²) = 9.487
// m from the middle of the circle, 0.487 m beyond the band.
TEST(WholeCost, ChargesNothingForCornersThatSwingOutOnHeadlandPasses) {
  Plan plan;
  plan.field = bare_field(100, 100);
  plan.body = {{plan.field.outer, {}}};
  plan.machine = {"", 6, 6};
  plan.machine.turning.implement_offset_m = 2;
  plan.machine.turning.rear_overhang_m = 1;
  EXPECT_NEAR(corner_swing_m(plan.machine), std::sqrt(90) - 9, 1e-12);
  plan.route.legs = {timed(LegKind::kHeadland, true, 900)};
  const auto charged = [&](LegKind kind, double missing_m) {
    plan.route.legs.front().kind = kind;
    plan.route.legs.front().missing_m = missing_m;
    return whole_cost(plan).without_room;
  };
  EXPECT_EQ(charged(LegKind::kHeadland, 0.48), 0);
  EXPECT_EQ(charged(LegKind::kHeadland, 0.55), 50);
  EXPECT_EQ(charged(LegKind::kWork, 0.48), 50);
  EXPECT_EQ(charged(LegKind::kTransit, 0.48), 50);
  plan.machine.turning = {};
  EXPECT_EQ(charged(LegKind::kHeadland, 0.001), 50);
}

// A vehicle 2 m wide that reaches 6 m ahead: √(7² + 6²) − 9 = 0.220 m. In tow its implement does not swing.
TEST(WholeCost, KnowsHowFarCornersSwing) {
  Machine machine{"", 6, 6};
  EXPECT_EQ(corner_swing_m(machine), 0);
  machine.turning.vehicle_width_m = 2;
  machine.turning.front_overhang_m = 6;
  EXPECT_NEAR(corner_swing_m(machine), std::sqrt(85) - 9, 1e-12);
  machine.turning.implement_offset_m = -5;  // in front of the axle: √(9² + 5²) − 9
  EXPECT_NEAR(corner_swing_m(machine), std::sqrt(106) - 9, 1e-12);
  machine.turning.implement_offset_m = 5;
  machine.turning.implement = Coupling::kTowed;
  machine.turning.drawbar_m = 4;
  EXPECT_NEAR(corner_swing_m(machine), std::sqrt(85) - 9, 1e-12);
}

// A seeder presses no crop, and what is not given is usual: 3.5 l/ha · 3 m · 2.5 m/s = 9.45 l/h.
TEST(WholeCost, TakesUsualRatesWhereNoneAreGiven) {
  Machine machine;
  machine.rates.operation = Operation::kSeeding;
  const Rates rates = rates_of(machine);
  EXPECT_NEAR(rates.fuel_l_per_h, 9.45, 1e-12);
  EXPECT_EQ(rates.sections, 1);
  EXPECT_EQ(rates.price_per_hour, 90);
  EXPECT_FALSE(works_standing_crop(Operation::kSeeding));
  for (int i = 0; i <= static_cast<int>(Operation::kDrone); ++i) {
    const auto operation = static_cast<Operation>(i);
    EXPECT_EQ(operation_named(name(operation)), operation);
  }
}

TEST(CheapestRoute, CostsNoMoreThanThePlanOfLeastCost) {
  for (const Field& field : {bare_field(300, 120), bare_field(90, 70)}) {
    PlanSettings settings = automatic_headlands();
    const Plan least = plan_field(field, {}, {}, settings, 1);
    settings.aim = Aim::kWholeCost;
    const ExplainedPlan whole = plan_and_explain(field, {}, {}, settings, 1);
    EXPECT_LE(whole_cost(whole.plan).euros(), whole_cost(least).euros() + 1e-9);
    EXPECT_EQ(whole.plan.proof.bound, 0);
    ASSERT_GE(whole.routes.size(), 2U);
    EXPECT_DOUBLE_EQ(whole.routes.front().cost.euros(), whole_cost(whole.plan).euros());
    for (const RouteAlternative& other : whole.routes) {
      EXPECT_GE(other.cost.euros(), whole_cost(whole.plan).euros() - 1e-9);
    }
  }
}

// Prices of tracks, by hand: 3 m · 2.5 m/s work 0.75 ha in 1,000 s. An hour costs 90 € and 20 l at 1.5 €:
// 120 €/h, so that a second is 1/30 € and a m² 1/225 €. Overlap also takes 100 €/ha / 4 of input, and
// uncovered land loses 1,000 €/ha less the work. With the work off a second costs (90 + 15)/3,600 €; half a
// circle of 6 m at 1.5 m/s takes 4π s, and from 12 m there is no way left to the fourth track. A stop
// takes a minute, and its price.
TEST(TrackPrices, AreWhatIsCalculatedByHand) {
  Machine machine;
  machine.rates = {Operation::kGeneral, 90, 20, 1.5, 4, 100, 1000, 7};
  const Objective prices = track_prices(machine);
  EXPECT_NEAR(prices.overlap, 0.01 / 4 + 1.0 / 225, 1e-12);
  EXPECT_NEAR(prices.uncovered, 0.1 - 1.0 / 225, 1e-12);
  EXPECT_NEAR(prices.turn, 4 * std::numbers::pi * 105 / 3600, 1e-12);
  EXPECT_NEAR(prices.stop, 7 + 60 * 105.0 / 3600, 1e-12);
  // Land that loses less than its work costs is still worked.
  machine.rates.margin_per_ha = 10;
  EXPECT_NEAR(track_prices(machine).uncovered, 1e-4, 1e-12);
}

// No route costs less than what its plan is estimated to cost at the least.
TEST(RouteFloor, IsBelowWhatTheRouteCosts) {
  for (const Field& field : {bare_field(300, 120), bare_field(90, 70), bare_field(60, 400)}) {
    PlanSettings settings = automatic_headlands();
    settings.aim = Aim::kWholeCost;
    const Plan plan = plan_field(field, {}, {}, settings, 1);
    const AllowedLand land(turning_land(plan.field, plan.machine, plan.settings));
    const double floor = route_floor(plan, land), cost = whole_cost(plan).euros();
    EXPECT_LE(floor, cost);
    EXPECT_GE(floor, 0.9 * cost);  // of plain rectangles little is left to chance
  }
}

// 600 m by 40 m: along its length it has some ten tracks, crosswise two hundred.
TEST(CheapestRoute, DrivesALongFieldLengthwise) {
  PlanSettings settings = automatic_headlands();
  settings.aim = Aim::kWholeCost;
  const Plan plan = plan_field(bare_field(600, 40), {}, {}, settings, 1);
  for (const Subfield& subfield : plan.subfields) EXPECT_NEAR(subfield.direction.degrees(), 90, 1e-6);
  EXPECT_EQ(legs_without_room(plan.route, plan.machine), 0U);
}

// A disc of 45 m is driven in 15 circles of 3 m from its rim to its centre, with no turn between tracks.
// Fewer passes leave a disc to tracks and cost more, and so does one pass more than turns need: the circles
// are not come to step by step.
TEST(CheapestRoute, DrivesARoundFieldInCircles) {
  Field field;
  field.id = "round";
  constexpr int kCorners = 72;
  for (int i = 0; i < kCorners; ++i) {
    const double turned = 2 * std::numbers::pi * i / kCorners;
    field.outer.push_back({45 * std::cos(turned), 45 * std::sin(turned)});
  }
  Machine machine;
  machine.width_m = 3;
  machine.radius_m = 4;
  PlanSettings settings = automatic_headlands();
  settings.aim = Aim::kWholeCost;
  const Plan plan = plan_field(field, machine, {}, settings, 1);
  EXPECT_TRUE(plan.pieces.empty());
  EXPECT_GE(plan.headland.passes.size(), 13U);
  EXPECT_LE(plan.headland.passes.size(), 15U);
  for (const int passes : {3, 6, 10}) {
    settings.headland_rule = HeadlandRule::kPasses;
    settings.headlands = passes;
    EXPECT_LT(whole_cost(plan).euros(), whole_cost(plan_field(field, machine, {}, settings, 1)).euros())
        << passes;
  }
}

// Tracks along a line that was given are not compared with others, and the plan says so.
TEST(CheapestRoute, AlongAGivenLineTheAimIsTheCostOfTracks) {
  PlanSettings settings = automatic_headlands();
  settings.aim = Aim::kWholeCost;
  settings.guide = {{0, 10}, {200, 10}};
  const ExplainedPlan plan = plan_and_explain(bare_field(200, 110), {}, {}, settings, 1);
  EXPECT_EQ(plan.plan.settings.aim, Aim::kCost);
  EXPECT_TRUE(plan.routes.empty());
}

/// Beside a line along y = 50 tracks lie by whole widths and a half.
void expect_beside(const Plan& plan, double y) {
  for (const TrackPiece& piece : plan.pieces) {
    const double widths = (piece.start.y - y) / plan.machine.width_m - 0.5;
    EXPECT_NEAR(widths, std::round(widths), 1e-6);
    EXPECT_NEAR(piece.end.y, piece.start.y, 1e-6);
  }
}

// A line says where tracks lie; they go on beyond its ends, whatever headlands their turns need.
TEST(CheapestRoute, TracksGoOnBeyondTheEndsOfALine) {
  PlanSettings settings = automatic_headlands();
  settings.aim = Aim::kWholeCost;
  settings.guide = {{90, 50}, {110, 50}};
  const Field field = bare_field(200, 110);
  const Plan plan = plan_field(field, {}, {}, settings, 1);
  ASSERT_FALSE(plan.pieces.empty());
  expect_beside(plan, 50);
  EXPECT_LT(plan.tally.uncovered_m2 + plan.headland.uncovered_m2, 0.05 * area_m2(field));
}

// An edit has the passes of the plan before, and its line.
TEST(PlanEdited, KeepsHeadlandsAndFollowsTheLine) {
  PlanSettings settings = automatic_headlands();
  settings.aim = Aim::kWholeCost;
  const Field field = bare_field(200, 110);
  const Plan before = plan_field(field, {}, {}, settings, 1);
  settings.guide = {{20, 50}, {60, 50}};
  const Plan edited = plan_edited(before, field, {}, {}, settings, 1);
  EXPECT_EQ(edited.headland.passes, before.headland.passes);
  expect_beside(edited, 50);
  EXPECT_TRUE(edited.route.planned());
  EXPECT_EQ(edited.proof.bound, 0) << "nothing was searched for";

  Field other = field;
  other.outer.push_back({-5, 50});
  EXPECT_THROW(plan_edited(before, other, {}, {}, settings, 1), Error);
}

TEST(CheapestRoute, IsTheSameForAnyNumberOfThreads) {
  PlanSettings settings = automatic_headlands();
  settings.aim = Aim::kWholeCost;
  const Plan one = plan_field(bare_field(200, 110), {}, {}, settings, 1),
             two = plan_field(bare_field(200, 110), {}, {}, settings, 2);
  EXPECT_EQ(whole_cost(one).euros(), whole_cost(two).euros());
  EXPECT_EQ(one.route.legs.size(), two.route.legs.size());
}

/// A field with one edge that bends, and a pond in its middle.
Field pond_field(double width_m, double height_m, double bend_m, double pond_m) {
  Field field = bare_field(width_m, height_m);
  field.outer.insert(field.outer.begin() + 1, {{width_m / 3, -bend_m}, {width_m / 1.5, -bend_m}});
  Ring pond;
  for (int i = 0; i < 10; ++i) {
    const double at = -2 * std::numbers::pi * i / 10;
    pond.push_back({0.5 * width_m + pond_m * std::cos(at), 0.5 * height_m + pond_m * std::sin(at)});
  }
  field.obstacles.emplace_back();
  field.obstacles.back().shape.outer = {pond.rbegin(), pond.rend()};
  return field;
}

// Curved tracks alone are not compared by their routes as other plans are; their headlands are. Which edge
// they follow best depends on these: with the headlands that turns of the tracks of the bare field need,
// these two fields cost 22 and 15 % more.
TEST(CurvedTracks, CostNoMoreThanBehindHeadlandsAskedFor) {
  Machine machine;
  machine.width_m = 12;
  machine.radius_m = 6;
  for (const Field& field : {pond_field(369, 214, 13, 9), pond_field(245, 244, 8, 16)}) {
    const auto euros = [&](const PlanSettings& settings) {
      return whole_cost(plan_field(field, machine, {}, settings)).euros();
    };
    PlanSettings free = automatic_headlands();
    free.obstacle_headland_rule = HeadlandRule::kTurns;
    free.shape = TrackShape::kCurved;
    free.aim = Aim::kWholeCost;
    const double least = euros(free);
    for (const int number : {1, 2}) {
      PlanSettings asked = free;
      asked.obstacle_headland_rule = HeadlandRule::kPasses;
      asked.obstacle_headlands = number;
      EXPECT_LE(least, euros(asked) + 1e-9) << number << " round the pond";
      asked = free;
      asked.headland_rule = HeadlandRule::kPasses;
      asked.headlands = number;
      EXPECT_LE(least, euros(asked) + 1e-9) << number << " round the field";
    }
  }
}

}  // namespace
}  // namespace tramline
