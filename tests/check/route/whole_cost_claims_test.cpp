// What a plan file says that its route costs: each false claim is found, and those that nothing refutes are
// named.

#include <gtest/gtest.h>

#include <limits>
#include <string>
#include <vector>

#include "check/route/hand_made_routes.h"
#include "tramline/check/file/compare_whole_cost.h"
#include "tramline/geometry/error.h"
#include "tramline/io/plan/plan_metadata.h"
#include "tramline/io/plan/route_rows.h"
#include "tramline/model/rate_values.h"

namespace tramline {
namespace {

using namespace testing_plans;

RouteLeg timed_leg(LegKind kind, bool work, double time_s) {
  RouteLeg out;
  out.kind = kind;
  out.work = work;
  out.time_s = time_s;
  out.path = {arc_from({{0, 0}, Heading::clockwise_from_north(Angle::degrees(90))}, 1, 0, Gear::kForward)};
  return out;
}

/// 45 minutes at work and 15 without.
Plan an_hour() {
  Plan plan;
  plan.machine.rates = {Operation::kSpraying, 60, 20, 1.5, 4, 100, 1000, 7};
  plan.tally.overlap_m2 = 200;
  plan.tally.uncovered_m2 = 50;
  plan.route.over_tracks_m = 100;
  plan.route.legs = {timed_leg(LegKind::kWork, true, 1800), timed_leg(LegKind::kTurn, false, 400),
                     timed_leg(LegKind::kHeadland, true, 900), timed_leg(LegKind::kBackOut, false, 200),
                     timed_leg(LegKind::kTransit, false, 300)};
  plan.route.legs[4].missing_m = 0.5;
  return plan;
}

/// Of an_hour(), by hand: 60 € for the hour; 20 l/h · (45 + 15/2) min = 17.5 l, 26.25 €; 200 m² twice with 4
/// sections at 100 €/ha: 0.50 €; 50 m² missed at 1,000 €/ha: 5 €; one stop: 7 €; 100 m · 1.2 m over crop: 12
/// €; one leg without room: 50 €.
StatedCost of_an_hour() { return {an_hour().machine.rates, 1, 17.5, 160.75}; }

Names found_in(const Plan& plan, const StatedCost& stated) {
  Names out;
  for (const check::Violation& violation : check::compare_whole_cost(plan, stated))
    out.emplace(name(violation.rule));
  return out;
}

const Names kFound{"whole cost"};

TEST(ClaimsOfWholeCosts, WhatIsCalculatedByHandHolds) {
  EXPECT_EQ(found_in(an_hour(), of_an_hour()), Names{});
  EXPECT_TRUE(check::rates_without_effect(an_hour(), of_an_hour()).empty());
}

TEST(ClaimsOfWholeCosts, LoweredTotalsAreFound) {
  const auto with = [](auto change) {
    StatedCost stated = of_an_hour();
    change(stated);
    return found_in(an_hour(), stated);
  };
  EXPECT_EQ(with([](StatedCost& s) { s.euros -= 0.01; }), kFound);
  EXPECT_EQ(with([](StatedCost& s) { s.hours_h -= 0.001; }), kFound);
  EXPECT_EQ(with([](StatedCost& s) { s.litres -= 0.01; }), kFound);
  EXPECT_EQ(with([](StatedCost& s) { s.euros = std::numeric_limits<double>::quiet_NaN(); }), kFound);
}

TEST(ClaimsOfWholeCosts, OtherPricesAreFound) {
  // Also where the machine does not say its own: then the total gives them away.
  Plan usual = an_hour();
  usual.machine.rates = Rates{};
  usual.machine.rates.operation = Operation::kSpraying;
  ASSERT_EQ(found_in(usual, of_an_hour()), Names{});
  for (const RateNumber& number : kRateNumbers) {
    StatedCost stated = of_an_hour();
    stated.rates.*number.value += 1;
    EXPECT_EQ(found_in(usual, stated), kFound) << number.key;
    EXPECT_EQ(found_in(an_hour(), stated), kFound) << number.key;
    // The machine's own price raised, and the whole cost left as it was.
    Plan raised = an_hour();
    raised.machine.rates.*number.value += 1;
    EXPECT_EQ(found_in(raised, of_an_hour()), kFound) << number.key;
  }
  StatedCost seeding = of_an_hour();
  seeding.rates.operation = Operation::kSeeding;
  EXPECT_EQ(found_in(an_hour(), seeding), kFound);
}

TEST(ClaimsOfWholeCosts, OtherWorkIsFound) {
  const auto with = [](auto change) {
    Plan plan = an_hour();
    change(plan);
    return found_in(plan, of_an_hour());
  };
  EXPECT_EQ(with([](Plan& p) { p.route.legs[1].time_s += 1; }), kFound);
  EXPECT_EQ(with([](Plan& p) { p.route.legs[4].missing_m = 0; }), kFound);
  EXPECT_EQ(with([](Plan& p) { p.route.legs[3].kind = LegKind::kTransit; }), kFound);
  EXPECT_EQ(with([](Plan& p) { p.route.over_tracks_m = 0; }), kFound);
  EXPECT_EQ(with([](Plan& p) { p.tally.overlap_m2 = 0; }), kFound);
  EXPECT_EQ(with([](Plan& p) { p.tally.uncovered_m2 = 0; }), kFound);
}

// An hour with the work off takes 60 € and 20 l/h · ½ · 1.50 € = 15 €: 7 € are 336 s of it.
TEST(ClaimsOfWholeCosts, WhatAStopCountsInTheBoundIsItsPrice) {
  const auto counted = [](double stop_s) {
    Plan plan = an_hour();
    plan.route.proof.stop_s = stop_s;
    return found_in(plan, of_an_hour());
  };
  EXPECT_EQ(counted(336), Names{});
  EXPECT_EQ(counted(0), Names{});  // a bound of the time alone
  EXPECT_EQ(counted(335), kFound);
  EXPECT_EQ(counted(std::numeric_limits<double>::quiet_NaN()), kFound);
  // No stop counts more than a quarter of an hour.
  Plan dear = an_hour();
  dear.machine.rates.price_per_stop = 30;
  StatedCost stated = of_an_hour();
  stated.rates.price_per_stop = 30;
  stated.euros += 23;
  dear.route.proof.stop_s = 900;
  EXPECT_EQ(found_in(dear, stated), Names{});
  dear.route.proof.stop_s = 1440;
  EXPECT_EQ(found_in(dear, stated), kFound);
}

// Nothing was backed out of, worked twice or missed: prices of these are not to be found in the total.
TEST(ClaimsOfWholeCosts, PricesWithoutEffectAreNamed) {
  Plan plan = an_hour();
  plan.machine.rates = Rates{};
  plan.tally = {};
  plan.route.over_tracks_m = 0;
  plan.route.legs.erase(plan.route.legs.begin() + 3);
  const StatedCost stated{an_hour().machine.rates, 1, 17.5, 160.75};
  EXPECT_EQ(check::rates_without_effect(plan, stated),
            (std::vector<std::string>{"whole_cost.rates.sections", "whole_cost.rates.input_price_per_ha",
                                      "whole_cost.rates.margin_per_ha", "whole_cost.rates.price_per_stop"}));
  // But for that of a stop where the bound of the route counts it.
  plan.route.proof.stop_s = 336;
  EXPECT_EQ(check::rates_without_effect(plan, stated).size(), 3U);
}

TEST(ClaimsOfWholeCosts, ComeBackFromAFileAndAreNotMissedInOlderOnes) {
  const Plan plan = route_plan();
  io::Metadata metadata = io::metadata_of(plan);
  const auto stated = io::stated_cost_in(metadata, "a.gpkg");
  ASSERT_TRUE(stated);
  EXPECT_EQ(stated->rates, rates_of(plan.machine));
  EXPECT_EQ(found_in(plan, *stated), Names{});
  metadata["whole_cost.rates.sections"] = "0";
  EXPECT_THROW(io::stated_cost_in(metadata, "a.gpkg"), Error);
  std::erase_if(metadata, [](const auto& row) { return row.first.starts_with("whole_cost."); });
  EXPECT_FALSE(io::stated_cost_in(metadata, "a.gpkg"));
}

}  // namespace
}  // namespace tramline
