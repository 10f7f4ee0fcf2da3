#include "report/explain_report.h"

#include <gtest/gtest.h>

namespace tramline::app {
namespace {

CausePart& part(Explanation& why, Cause cause) { return why.causes.parts[static_cast<std::size_t>(cause)]; }

Direction direction(double degrees) { return Direction::clockwise_from_north(Angle::degrees(degrees)); }

/// Costs 20: 10 at row ends, 5.45 for a stop and what is left beside it, 4.55 for turns.
Explanation explanation() {
  Explanation why;
  part(why, Cause::kRowEnds) = {200, 20, 0, 10};
  part(why, Cause::kSides) = {-1e-10, 0.01, 0, 0.001};
  part(why, Cause::kStops) = {-1e-10, 4.5, 1, 5.45};
  part(why, Cause::kTurns) = {0, 0, 10, 4.549};
  RunnerUp across;
  across.directions = {direction(12.5), direction(100)};
  across.tally.overlap_m2 = 225;
  across.tally.uncovered_m2 = 24.51;
  across.tally.turns = 14;
  across.tally.pieces = 15;
  across.cost = 17.8;
  across.more = {1, 0, 1.8, -5, 0};
  why.runner_ups = {across};
  why.longest_side = across;
  why.longest_side.directions = {direction(12.5)};
  return why;
}

TEST(ExplainRows, NameTheCausesThatCostAnythingAndTheRunnerUps) {
  EXPECT_EQ(explain_rows(explanation(), 20),
            "cost by cause          overlap     uncovered   count        cost     share\n"
            "  row ends            200.0 m²       20.0 m²               10.00    50.0 %\n"
            "  stops                 0.0 m²        4.5 m²       1        5.45    27.2 %\n"
            "  turns                 0.0 m²        0.0 m²      10        4.55    22.7 %\n"
            "runner-ups              cost        more            mainly for   overlap  uncovered     turns   "
            "  stops  "
            "subfields (direction)\n"
            "  1                    17.80       -2.20   -11.0 %  turns          +1.00      +0.00     +1.80   "
            "  -5.00  "
            "2 (12.50°, 100.00°)\n"
            "longest side  all tracks along it, at 12.50°, would cost 17.80, 2.20 less: overlap 225.0 m², "
            "uncovered 24.5 m², 14 turns, 0 stops\n");
}

TEST(ExplainRows, SayWhenThereIsNoOtherPlan) {
  Explanation why;
  why.longest_side.directions = {direction(90)};
  why.longest_side.tally.pieces = 0;
  EXPECT_EQ(explain_rows(why, 0),
            "cost by cause          overlap     uncovered   count        cost     share\n"
            "runner-ups   none differs by a degree or in its number of subfields\n"
            "longest side  at 90.00° no track fits\n");
}

TEST(ExplainJson, HasEveryCauseInOrder) {
  const nlohmann::ordered_json json = explain_json(explanation());
  std::string names;
  for (const auto& cause : json["causes"]) names += cause["cause"].get<std::string>() + "; ";
  EXPECT_EQ(names,
            "row ends; sides; seams; detours; stops; short pieces; given up; turns; subfields; headland; ");
  EXPECT_EQ(json["causes"][0].dump(),
            R"({"cause":"row ends","overlap_m2":200.0,"uncovered_m2":20.0,"count":null,"cost":10.0})");
  EXPECT_EQ(json["causes"][4]["count"], 1);
  EXPECT_EQ(
      json["runner_ups"].dump(),
      R"([{"direction_deg":[12.5,100.0],"subfields":2,"overlap_m2":225.0,"uncovered_m2":24.51,"turns":14,)"
      R"("stops":0,"cost":17.8,"more":-2.2,"more_by":{"overlap":1.0,"uncovered":0.0,"turns":1.8,"stops":-5.0,"subfields":0.0},)"
      R"("main_reason":"turns"}])");
}

}  // namespace
}  // namespace tramline::app
