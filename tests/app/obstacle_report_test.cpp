#include "report/obstacle_report.h"

#include <gtest/gtest.h>

#include <cmath>

namespace tramline::app {
namespace {

const WayPast kNeverThere{false, 0, "detour would leave the body"};
const WayPast kTooTight{false, 0, "too tight"};

Encounter cut(const WayPast& left, const WayPast& right) {
  Encounter out;
  out.left = left;
  out.right = right;
  return out;
}

/// Half a circle to the left, radius 6 m: all a summary looks at.
Detour detour(Passing side) { return {{{{0, 0}, {0, 12}, 1 / 6.0}}, side, {0}}; }

TEST(ReasonForCut, IsThePriceWhereThereIsAWay) {
  EXPECT_EQ(reason_for_cut(cut(kTooTight, {true, 2, ""}), Avoidance::kCheapest), "cutting costs less");
  EXPECT_EQ(reason_for_cut(cut({true, 5, ""}, {true, 2, ""}), Avoidance::kCheapest), "cutting costs less");
  EXPECT_EQ(reason_for_cut(cut({true, 5, ""}, {true, -2, ""}), Avoidance::kPaper), "as --avoid paper asks")
      << "the other way would have been cheaper: a price is no reason";
  EXPECT_EQ(reason_for_cut(cut(kTooTight, kTooTight), Avoidance::kCut), "as --avoid cut asks");
}

TEST(ReasonForCut, IsWhatStandsInTheWayElsewhere) {
  EXPECT_EQ(reason_for_cut(cut(kTooTight, kTooTight), Avoidance::kCheapest), "too tight");
  EXPECT_EQ(reason_for_cut(cut(kTooTight, kNeverThere), Avoidance::kCheapest),
            "detour would leave the body / too tight");
  EXPECT_EQ(reason_for_cut(cut(kNeverThere, kTooTight), Avoidance::kCheapest),
            reason_for_cut(cut(kTooTight, kNeverThere), Avoidance::kCheapest))
      << "mirror images are one reason";
  EXPECT_EQ(reason_for_cut(cut({}, kTooTight), Avoidance::kCheapest), "too tight");
  EXPECT_EQ(reason_for_cut(cut({}, {}), Avoidance::kCheapest), "no way round");
}

TEST(ObstacleRows, AreAbsentWhereNoTrackMeetsAnObstacle) { EXPECT_EQ(obstacle_rows(Plan{}), ""); }

TEST(ObstacleRows, CountWaysAndReasons) {
  Plan plan;
  plan.pieces.resize(2);
  plan.pieces[0].detours = {detour(Passing::kLeft), detour(Passing::kRight)};
  plan.pieces[1].detours = {detour(Passing::kLeft)};
  Encounter passed;
  passed.chosen = Passing::kLeft;
  plan.encounters = {passed,
                     passed,
                     passed,
                     cut(kTooTight, kTooTight),
                     cut({true, 1, ""}, kTooTight),
                     cut(kNeverThere, {true, 3, ""})};
  EXPECT_EQ(obstacle_rows(plan),
            "detours      3 (2 left, 1 right), smallest radius 6.00 m\n"
            "cut          3 of 6 encounters with obstacles: cutting costs less (2), too tight (1)\n");
  plan.pieces.clear();
  plan.encounters = {cut(kTooTight, kTooTight)};
  EXPECT_EQ(obstacle_rows(plan),
            "detours      0\ncut          1 of 1 encounters with obstacles: too tight (1)\n");
}

TEST(ObstacleKeys, AreThoseOfTheDocumentation) {
  Plan plan;
  plan.machine.width_m = 4;
  nlohmann::ordered_json none;
  add_obstacle_keys(none, plan);
  EXPECT_EQ(
      none.dump(),
      R"({"avoid":"cheapest","avoid_threshold_m":4.0,"avoid_room_m":null,"clearance_m":0.0,"detours":0,)"
      R"("smallest_radius_m":null,"encounters":[]})");

  plan.settings.avoid = Avoidance::kPaper;
  plan.settings.avoid_threshold_m = 0;
  plan.pieces.resize(1);
  plan.pieces[0].detours = {detour(Passing::kRight)};
  plan.encounters = {{1, 7, {2.5, 3}, {0, 4}, Passing::kRight, kTooTight, {true, -1.25, ""}}};
  nlohmann::ordered_json some;
  add_obstacle_keys(some, plan);
  EXPECT_EQ(some["avoid_threshold_m"], 0.0);
  EXPECT_NEAR(some["smallest_radius_m"].get<double>(), 6, 1e-12);
  EXPECT_EQ(
      some["encounters"].dump(),
      R"([{"subfield":2,"track":8,"x_m":2.5,"y_m":3.0,"obstacles":[1,5],"chosen":"right","cost_left":null,)"
      R"("cost_right":-1.25,"why_not_left":"too tight","why_not_right":null}])");
}

}  // namespace
}  // namespace tramline::app
