#include "report/front_report.h"

#include <gtest/gtest.h>

namespace tramline::app {
namespace {

Direction degrees(double value) { return Direction::clockwise_from_north(Angle::degrees(value)); }

/// Costs at 1, 1, 1, 1: 10 + 0 + 6 = 16 (a rounding below zero included) and 2.5 + 3 + 9 + 1 = 15.5.
Front sample() {
  Front front;
  front.prices = {1, 1, 1, 1};
  front.points.resize(2);
  front.points[0].tally.overlap_m2 = -0.0;
  front.points[0].tally.uncovered_m2 = 10;
  front.points[0].tally.turns = 6;
  front.points[0].directions = {degrees(30)};
  front.points[0].cost = 16;
  front.points[1].tally.overlap_m2 = 2.5;
  front.points[1].tally.uncovered_m2 = 3;
  front.points[1].tally.turns = 9;
  front.points[1].tally.stops = 1;
  front.points[1].directions = {degrees(0), degrees(90)};
  front.points[1].cost = 15.5;
  front.marks = {0, 1, 0, 1, 1};
  return front;
}

TEST(FrontCsv, HasAHeaderAndALineForEachPoint) {
  const std::string csv = front_csv(sample());
  const std::string head = "point,overlap_m2,uncovered_m2,turns,stops,subfields,direction_deg,cost,marks\n";
  ASSERT_TRUE(csv.starts_with(head));
  EXPECT_TRUE(csv.starts_with(head + "1,0,10,6,0,1,")) << csv;
  EXPECT_TRUE(
      csv.ends_with(",16,least_overlap;fewest_turns_and_stops\n"
                    "2,2.5,3,9,1,2,0;90,15.5,given_prices;knee;least_uncovered\n"))
      << csv;
}

TEST(CompareReports, NameTheWinnersForOtherPrices) {
  const Front front = sample();
  const Field field{};
  const std::vector<Objective> asked{{0, 0, 1, 0}, {1, 1, 0, 0}};
  const Machine machine;
  const PlanSettings settings;
  const Comparison comparison{field, machine, settings, front, asked, 0.5};
  const auto json = compare_json(comparison, {});
  EXPECT_EQ(json["winners"][0]["point"], 1);
  EXPECT_EQ(json["winners"][0]["cost"], 6);
  EXPECT_EQ(json["winners"][1]["point"], 2);
  EXPECT_EQ(json["winners"][1]["cost"], 5.5);
  const std::string table = compare_table(comparison, {});
  EXPECT_NE(table.find("plan 1 costs least, 6.00, for 0·overlap"), std::string::npos) << table;
  EXPECT_NE(table.find("plan 2 costs least, 5.50, for 1·overlap"), std::string::npos) << table;
}

}  // namespace
}  // namespace tramline::app
