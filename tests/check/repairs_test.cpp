// Repairs: one that holds, and each fault made on purpose under its name.

#include <gtest/gtest.h>

#include "check/plans.h"

namespace tramline {
namespace {

using namespace testing_plans;

/// Two gaps of 4 × 20 m in line, 30 m apart, in a square of 100 m, worked by one line along x = 50 with
/// w = 4: two pieces of 20 m, nothing in vain.
Plan repair() {
  const Region gaps{{{{48, 10}, {52, 10}, {52, 30}, {48, 30}}, {}},
                    {{{48, 60}, {52, 60}, {52, 80}, {48, 80}}, {}}};
  Plan plan;
  plan.field.id = "repair";
  plan.field.outer = {{0, 0}, {100, 0}, {100, 100}, {0, 100}};
  plan.machine.width_m = 4;
  plan.machine.min_length_m = 0;
  plan.settings.boundary = EdgeKind::kHard;
  plan.settings.end_rule = EndRule::kCover;
  plan.settings.avoid = Avoidance::kCut;
  plan.kind = PlanKind::kRepair;
  plan.body = gaps;
  plan.worked = {{plan.field.outer,
                  {{{48, 30}, {52, 30}, {52, 10}, {48, 10}}, {{48, 80}, {52, 80}, {52, 60}, {48, 60}}}}};
  const Direction north = Direction::clockwise_from_north(Angle::degrees(0));
  plan.subfields = {{gaps[0], north}, {gaps[1], north}};
  plan.pieces.push_back({{50, 10}, {50, 30}, 0, 0});
  plan.pieces.push_back({{50, 60}, {50, 80}, 0, 0});
  plan.pieces[1].after_crossing = true;
  return settled(plan);
}

TEST(Repairs, AGoodOneHolds) {
  const Plan plan = repair();
  EXPECT_EQ(found(plan), Names{});
  EXPECT_EQ(plan.tally.crossings, 1);
  EXPECT_EQ(plan.tally.turns, 0);
}

TEST(Repairs, GroundThatIsNeitherWorkedNorAGap) {
  Plan plan = repair();
  plan.worked[0].holes.push_back({{10, 20}, {20, 20}, {20, 10}, {10, 10}});
  EXPECT_EQ(found(plan), Names{"body"});
}

TEST(Repairs, WorkedGroundThatIsAGap) {
  Plan plan = repair();
  plan.worked[0].holes.pop_back();
  EXPECT_EQ(found(plan), Names{"body"});
}

// 2.1 m beyond the gap are more than the work may go on for; 1.9 m are not.
TEST(Repairs, WorkThatGoesOnFarOverWorkedGround) {
  Plan plan = repair();
  plan.pieces[0].end.y = 31.9;
  EXPECT_EQ(found(settled(plan)), Names{});
  plan.pieces[0].end.y = 32.1;
  EXPECT_EQ(found(settled(plan)), Names{"ends"});
}

TEST(Repairs, ACrossingThroughAnObstacle) {
  Plan plan = repair();
  const Polygon pond{{{45, 40}, {55, 40}, {55, 50}, {45, 50}}, {}};
  plan.field.obstacles = {{pond, ObstacleKind::kObstacle, "pond"}};
  plan.worked[0].holes.push_back({{45, 50}, {55, 50}, {55, 40}, {45, 40}});
  EXPECT_EQ(found(plan), Names{"crossings"});
}

// The boundary comes in from the east between the two gaps, as far as x = 49.
TEST(Repairs, ACrossingBeyondTheField) {
  Plan plan = repair();
  plan.field.outer = {{0, 0}, {100, 0}, {100, 40}, {49, 40}, {49, 50}, {100, 50}, {100, 100}, {0, 100}};
  plan.worked[0].outer = plan.field.outer;
  EXPECT_EQ(found(plan), Names{"crossings"});
}

TEST(Repairs, ASwathThatLeavesTheField) {
  Plan plan = repair();
  plan.field.outer = {{0, 0}, {51.5, 0}, {51.5, 100}, {0, 100}};
  plan.body = {{{{48, 10}, {51.5, 10}, {51.5, 30}, {48, 30}}, {}},
               {{{48, 60}, {51.5, 60}, {51.5, 80}, {48, 80}}, {}}};
  plan.subfields[0].shape = plan.body[0];
  plan.subfields[1].shape = plan.body[1];
  plan.worked = {{{{0, 0},
                   {51.5, 0},
                   {51.5, 10},
                   {48, 10},
                   {48, 30},
                   {51.5, 30},
                   {51.5, 60},
                   {48, 60},
                   {48, 80},
                   {51.5, 80},
                   {51.5, 100},
                   {0, 100}},
                  {}}};
  const Names rules_found = found(settled(plan));
  EXPECT_TRUE(rules_found.contains("swaths"));
}

}  // namespace
}  // namespace tramline
