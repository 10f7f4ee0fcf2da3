// Plans with headlands along some edges, and with plain ones, hold.

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <string>
#include <vector>

#include "tramline/check/verify.h"
#include "tramline/geometry/error.h"
#include "tramline/geometry/path/path.h"
#include "tramline/geometry/polygon/boolean.h"
#include "tramline/planner/plan_field.h"

namespace tramline::planned_headlands_test {

/// 300 × 200 m with two passes along its western and eastern sides, where the tracks turn.
Plan plan_with_turning_sides() {
  Field field;
  field.id = "sides";
  field.outer = {{0, 0}, {300, 0}, {300, 200}, {0, 200}};
  PlanSettings settings;
  settings.headland_edges = {0, 2, 0, 2};
  return plan_field(field, {"", 6, 6, -1}, Objective{}, settings, 1);
}

Path moved_by(const Path& path, Point by) {
  return moved(path, [by](Point p) { return p + by; });
}

std::set<std::string> broken_rules(const Plan& plan) {
  std::set<std::string> out;
  for (const check::Violation& v : check::verify(plan).violations) out.emplace(name(v.rule));
  return out;
}

TEST(PlannedPlans, LeaveNothingWhereTracksTurnAtTwoSides) {
  const Plan plan = plan_with_turning_sides();
  EXPECT_EQ(broken_rules(plan), std::set<std::string>{});
  EXPECT_EQ(plan.headland.passes.size(), 4U);
  EXPECT_EQ(plan.settings.headlands, 2);
  EXPECT_EQ(plan.settings.boundary, EdgeKind::kHard);
  EXPECT_NEAR(area(plan.body), 276 * 200, 1e-3);
  for (const Ring& ring : rings_of(swaths(plan)))
    for (const Point p : ring) {
      EXPECT_GT(p.y, -1e-6);
      EXPECT_LT(p.y, 200 + 1e-6);
    }
}

TEST(PlannedPlans, HeadlandsAlongEdgesThatAreNotWhatTheyShouldBe) {
  const Plan sound = plan_with_turning_sides();
  const auto broken = [&sound](const auto& change) {
    Plan plan = sound;
    change(plan);
    return broken_rules(plan);
  };
  const double outwards_m = sound.headland.passes[0].path[0].from.x < 150 ? -0.1 : 0.1;
  EXPECT_TRUE(broken([&](Plan& plan) {
                auto& path = plan.headland.passes[0].path;
                path = moved_by(path, {outwards_m, 0});
              }).contains("swaths"));
  EXPECT_TRUE(broken([&](Plan& plan) {
                auto& path = plan.headland.passes[0].path;
                path = moved_by(path, {-outwards_m, 0});
              }).contains("tally"));
  const auto second = std::find_if(sound.headland.passes.begin(), sound.headland.passes.end(),
                                   [](const HeadlandPass& pass) { return pass.number == 2; });
  ASSERT_NE(second, sound.headland.passes.end());
  const auto at = static_cast<std::size_t>(second - sound.headland.passes.begin());
  const double towards_m = second->path[0].from.x < 150 ? -0.1 : 0.1;
  EXPECT_TRUE(broken([&](Plan& plan) {
                plan.headland.passes[at].path = moved_by(plan.headland.passes[at].path, {towards_m, 0});
              }).contains("headland"));
  EXPECT_TRUE(broken([&](Plan& plan) {
                plan.headland.passes[at].path = moved_by(plan.headland.passes[at].path, {0, 0.1});
              }).contains("swaths"));
  EXPECT_TRUE(broken([](Plan& plan) { plan.headland.passes.pop_back(); }).contains("tally"));
  EXPECT_TRUE(broken([](Plan& plan) { plan.headland.edge_passes[0] = 1; }).contains("headland"));
  EXPECT_TRUE(broken([](Plan& plan) {
                plan.headland.edge_passes = plan.settings.headland_edges = {0, 1, 0, 2};
              }).contains("body"));
  EXPECT_TRUE(broken([](Plan& plan) {
                plan.headland.edge_passes = plan.settings.headland_edges = {0, 2, 2};
              }).contains("headland"));
  EXPECT_TRUE(broken([](Plan& plan) { plan.body[0].outer[0].x += 0.5; }).contains("body"));
}

/// Numbers that no field has.
TEST(PlannedPlans, RefuseHeadlandsAlongEdgesThatAreNotThere) {
  Field field;
  field.id = "sides";
  field.outer = {{0, 0}, {300, 0}, {300, 200}, {0, 200}};
  PlanSettings settings;
  for (const std::vector<int>& passes : {std::vector<int>{1, 2}, std::vector<int>{1, -1, 0, 0}}) {
    settings.headland_edges = passes;
    EXPECT_THROW(plan_field(field, {"", 6, 6, -1}, Objective{}, settings, 1), Error);
  }
}

/// As many along every edge are as many round the field.
TEST(PlannedPlans, EqualHeadlandsAlongAllEdgesAreThoseRoundTheField) {
  Field field;
  field.id = "sides";
  field.outer = {{0, 0}, {300, 0}, {300, 200}, {0, 200}};
  PlanSettings by_edge, all_round;
  by_edge.headland_edges = {2, 2, 2, 2};
  all_round.headlands = 2;
  const Plan one = plan_field(field, {"", 6, 6, -1}, Objective{}, by_edge, 1);
  const Plan other = plan_field(field, {"", 6, 6, -1}, Objective{}, all_round, 1);
  EXPECT_EQ(one.headland.passes, other.headland.passes);
  EXPECT_TRUE(one.settings.headland_edges.empty());
  EXPECT_EQ(one.settings.headlands, 2);
  EXPECT_EQ(one.cost, other.cost);
}

// Plain headlands and tracks from the envelope hold in every figure, with obstacles that are near one another
// and near the edge.
TEST(PlannedPlans, WithPlainHeadlandsHold) {
  Field field;
  field.id = "notched";
  field.outer = {{0, 0}, {100, 0}, {100, 60}, {60, 60}, {60, 25}, {40, 60}, {0, 60}};
  field.obstacles.push_back(
      {{{{20, 20}, {30, 20}, {30, 30}, {20, 30}}, {}}, ObstacleKind::kObstacle, "pond"});
  field.obstacles.push_back(
      {{{{46, 20}, {54, 20}, {54, 22}, {48, 22}}, {}}, ObstacleKind::kObstacle, "mast"});
  PlanSettings settings;
  settings.tracks = TrackConstruction::kPaper;
  settings.end_rule = EndRule::kCover;
  settings.headlands = settings.obstacle_headlands = 2;
  settings.guide = {{0, 30}, {100, 50}};
  Plan plan = plan_field(field, {"", 4, 6, 0}, {}, settings, 1);
  EXPECT_GT(plan.headland.passes.size(), 2U);
  for (const check::Violation& each : check::verify(plan).violations)
    ADD_FAILURE() << name(each.rule) << ": " << each.what;
  const auto finds = [&plan](check::Rule rule) {
    const std::vector<check::Violation> found = check::verify(plan).violations;
    return std::any_of(found.begin(), found.end(), [rule](const auto& each) { return each.rule == rule; });
  };
  plan.headland.construction = HeadlandConstruction::kDrivable;
  EXPECT_TRUE(finds(check::Rule::kDrivable)) << "kinks";
  plan.headland.construction = HeadlandConstruction::kPlain;
  for (Subfield& subfield : plan.subfields) subfield.reference = {{{0, 30}, {100, 50}, 0}};
  EXPECT_TRUE(finds(check::Rule::kParallel)) << "the line is not the side of the envelope";
}

}  // namespace tramline::planned_headlands_test
