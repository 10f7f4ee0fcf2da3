#include "report/turning/route_report.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "report/plan_summary.h"

namespace tramline::app {
namespace {

RouteLeg straight(LegKind kind, Gear gear, bool work, Point from, double length_m, double time_s) {
  const Heading east = Heading::clockwise_from_north(Angle::degrees(90));
  RouteLeg out{kind, gear, work, {arc_from({from, east}, length_m, 0, gear)}};
  out.time_s = time_s;
  return out;
}

/// 600 m along a track, 200 m along a pass, 150 m of ways with the work off and 50 m in reverse: a fifth of
/// 1000 m is no work. 900 s, where nothing takes less than 720 s.
Plan routed() {
  Plan out;
  out.machine.turning.working_speed_mps = 2;
  out.machine.turning.turning_speed_mps = 1.5;
  out.machine.turning.reverse_speed_mps = 1;
  auto& legs = out.route.legs;
  legs = {straight(LegKind::kWork, Gear::kForward, true, {0, 0}, 600, 300),
          straight(LegKind::kTurn, Gear::kForward, false, {600, 0}, 100, 200),
          straight(LegKind::kBackOut, Gear::kReverse, false, {700, 0}, 50, 100),
          straight(LegKind::kTransit, Gear::kForward, false, {650.25, 4}, 50, 100),
          straight(LegKind::kHeadland, Gear::kForward, true, {700, 4}, 200, 200)};
  legs[0].piece = 0;
  legs[4].pass = 1;
  out.route.proof.bound_s = 720;
  out.route.over_worked_m = 30;
  out.route.over_unworked_m = 20;
  out.route.over_tracks_m = 10;
  return out;
}

TEST(RouteReport, SaysTheWayInOneLineWhereAllHasRoom) {
  EXPECT_EQ(route_rows(routed()),
            "route        1.000 km (2 m/s, 1.5 m/s with the work off, 1 m/s in reverse), "
            "20.0 % of it not working; at most 25.0 % longer than the quickest\n");
}

TEST(RouteReport, NamesLegsWithoutRoom) {
  Plan tight = routed();
  tight.route.legs[3].missing_m = 1.25;
  const std::string one = route_rows(tight);
  EXPECT_EQ(one.substr(one.find('\n') + 1),
            "no room      for 1 leg, which leaves the land by up to 1.2 m: leg 4 from (650.2, 4.0)\n");
  for (RouteLeg& leg : tight.route.legs) leg.missing_m = 2;
  const std::string all = route_rows(tight);
  EXPECT_EQ(all.substr(all.find('\n') + 1),
            "no room      for 5 legs, which leave the land by up to 2.0 m: leg 1 from (0.0, 0.0), "
            "leg 2 from (600.0, 0.0), leg 3 from (700.0, 0.0) and 2 more\n");
}

TEST(RouteReport, WithoutARouteThereIsNothingToSay) { EXPECT_EQ(route_rows(Plan{}), ""); }

// 0.25 h at 90 €/h; at 5 l/ha · 3 m · 2 m/s = 10.8 l/h, half of it with the work off.
TEST(RouteReport, WholeCostIsOneRow) {
  const std::string row = whole_cost_row(routed());
  EXPECT_EQ(row.find("whole cost   "), 0U) << row;
  EXPECT_NE(row.find(", 0.25 h: machine 22.50 €, "), std::string::npos) << row;
  EXPECT_NE(row.find(" l of fuel "), std::string::npos) << row;
  EXPECT_NE(row.find(" €, worked twice 0.00 €, missed 0.00 €, stops 1.00 €; field efficiency "),
            std::string::npos)
      << row;
  EXPECT_EQ(row.find("without room"), std::string::npos) << row;
  EXPECT_EQ(whole_cost_row(Plan{}), "");
}

TEST(RouteReport, LegsWithoutRoomAreAPartOfTheWholeCost) {
  Plan tight = routed();
  tight.route.legs[1].missing_m = tight.route.legs[3].missing_m = 0.5;
  EXPECT_NE(whole_cost_row(tight).find(", stops 1.00 €, legs without room 100.00 €; field efficiency "),
            std::string::npos)
      << whole_cost_row(tight);
  EXPECT_DOUBLE_EQ(whole_cost_json(tight).at("euros_without_room").get<double>(), 100);
}

// 900 s and one back-out of 60 s against 768 s.
TEST(RouteReport, StopsCountInWhatIsProven) {
  Plan priced = routed();
  priced.route.proof.bound_s = 768;
  priced.route.proof.stop_s = 60;
  EXPECT_NE(
      route_rows(priced).find("; at most 25.0 % above the best, each stop to back out counted as 60 s\n"),
      std::string::npos)
      << route_rows(priced);
  EXPECT_DOUBLE_EQ(route_json(priced).at("gap").get<double>(), 0.2);
  EXPECT_EQ(route_json(priced).at("back_outs"), 1);
  EXPECT_EQ(route_json(priced).at("stop_s"), 60);
  priced.route.legs.erase(priced.route.legs.begin() + 2);  // nothing to back out of
  EXPECT_NE(route_rows(priced).find(" % above the best\n"), std::string::npos) << route_rows(priced);
}

TEST(RouteReport, NoBoundProvesNothing) {
  Plan unproven = routed();
  unproven.route.proof.bound_s = 0;
  EXPECT_EQ(route_rows(unproven).find("at most"), std::string::npos);
}

TEST(RouteReport, JsonHasSumsAndLegs) {
  Plan tight = routed();
  tight.route.legs[1].missing_m = 0.5;
  const nlohmann::ordered_json json = route_json(tight);
  EXPECT_EQ(json.at("length_m"), 1000);
  EXPECT_EQ(json.at("working_m"), 600);
  EXPECT_EQ(json.at("headland_m"), 200);
  EXPECT_EQ(json.at("turning_m"), 150);
  EXPECT_EQ(json.at("transit_m"), 50);
  EXPECT_EQ(json.at("reverse_m"), 50);
  EXPECT_EQ(json.at("time_s"), 900);
  EXPECT_EQ(json.at("bound_s"), 720);
  EXPECT_DOUBLE_EQ(json.at("gap").get<double>(), 0.2);
  EXPECT_EQ(json.at("without_room"), 1);
  EXPECT_EQ(json.at("over_worked_m"), 30);
  EXPECT_EQ(json.at("over_unworked_m"), 20);
  EXPECT_EQ(json.at("over_tracks_m"), 10);
  EXPECT_EQ(json.at("legs").size(), 5U);
  EXPECT_EQ(
      json.at("legs").at(0).dump(),
      R"({"seq":1,"kind":"work","gear":"forward","work":true,"length_m":600.0,"time_s":300.0,"piece":1})");
  EXPECT_EQ(json.at("legs").at(1).at("missing_m"), 0.5);
  EXPECT_EQ(json.at("legs").at(2).at("gear"), "reverse");
  EXPECT_FALSE(json.at("legs").at(2).contains("missing_m"));
  EXPECT_EQ(json.at("legs").at(4).at("pass"), 2);
}

TEST(RouteReport, IsPartOfTheSummary) {
  EXPECT_NE(figure_rows(routed()).find(route_rows(routed())), std::string::npos);
}

}  // namespace
}  // namespace tramline::app
