// What the planner makes holds: closed forms on one road, polygon booleans on the other.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>
#include <vector>

#include "properties/random_field.h"
#include "properties/seeds.h"
#include "tramline/check/verify.h"
#include "tramline/geometry/error.h"
#include "tramline/model/limits.h"
#include "tramline/planner/plan_field.h"

namespace tramline::planned_plans_test {

using testing::case_count;

PlanSettings random_settings(std::mt19937_64& random) {
  const auto pick = [&random](int n) { return std::uniform_int_distribution<int>(0, n - 1)(random); };
  PlanSettings out;
  out.end_rule = static_cast<EndRule>(pick(4));
  out.boundary = pick(3) == 0 ? EdgeKind::kHard : EdgeKind::kSoft;
  out.merge_threshold = Angle::degrees(pick(2) * 15);
  return out;
}

TEST(PlannedPlans, HoldOnRandomFields) {
  int planned = 0;
  const int cases = case_count(20);
  for (int i = 0; i < cases; ++i) {
    testing::SeededRandom random(i);
    const Field field = testing::random_field(random, 4);
    Machine machine;
    machine.width_m = std::uniform_real_distribution<double>(1.5, 8)(random);
    const PlanSettings settings = random_settings(random);
    try {
      const check::Verdict verdict = check::verify(plan_field(field, machine, Objective{}, settings, 1));
      EXPECT_TRUE(verdict.complete);
      for (const check::Violation& v : verdict.violations) ADD_FAILURE() << name(v.rule) << ": " << v.what;
      ++planned;
    } catch (const Error& error) {
      EXPECT_EQ(error.kind(), ErrorKind::kBadInput) << error.what();  // no track fits
    }
  }
  EXPECT_GT(2 * planned, cases);
}

/// Numbers of headland passes by edge, in runs; some edges have none.
std::vector<int> random_headland_edges(std::mt19937_64& random, std::size_t edges) {
  const auto pick = [&random](int least, int most) {
    return std::uniform_int_distribution<int>(least, most)(random);
  };
  std::vector<int> out;
  while (out.size() < edges)
    out.insert(out.end(), static_cast<std::size_t>(pick(1, 4)), std::max(0, pick(-1, 2)));
  out.resize(edges);
  return out;
}

TEST(PlannedPlans, HoldWithHeadlandsAlongSomeEdges) {
  int planned = 0;
  const int cases = case_count(10);
  for (int i = 0; i < cases; ++i) {
    testing::SeededRandom random(i);
    const Field field = testing::random_field(random, i % 2 == 0 ? 0 : 4);
    Machine machine;
    machine.width_m = std::uniform_real_distribution<double>(1.5, 8)(random);
    PlanSettings settings = random_settings(random);
    settings.headland_edges = random_headland_edges(random, field.outer.size());
    settings.obstacle_headlands = i % 4 == 1 ? 1 : 0;
    try {
      const Plan plan = plan_field(field, machine, Objective{}, settings, 1);
      EXPECT_NEAR(identity_error_m2(plan), 0, 1e-6 * land_m2(plan));
      for (const check::Violation& v : check::verify(plan).violations)
        ADD_FAILURE() << name(v.rule) << ": " << v.what << ", case " << i;
      ++planned;
    } catch (const Error& error) {
      EXPECT_EQ(error.kind(), ErrorKind::kBadInput) << error.what();
    }
  }
  EXPECT_GT(2 * planned, cases);
}

/// A block of 240 × 102 m, 17 swaths of 6 m, with an arm of 24 m that leaves its north-western corner and
/// bends through a quarter circle.
Field block_with_bent_arm() {
  Field field;
  field.id = "bent";
  field.outer = {{60, -102}, {300, -102}, {300, 0}};
  constexpr int kChords = 60;
  for (const bool outwards : {true, false})
    for (int i = 0; i <= kChords; ++i) {
      const double turn = 0.5 * std::numbers::pi * (outwards ? i : kChords - i) / kChords;
      const double radius = outwards ? 84 : 60;
      field.outer.push_back({radius * std::cos(turn), radius * std::sin(turn)});
    }
  return field;
}

/// The block in straight tracks, the arm round its bend: 21 tracks, and next to nothing lost but at the
/// border.
TEST(PlannedPlans, OfStraightAndCurvedSubfieldsHold) {
  const Field field = block_with_bent_arm();
  Machine machine;
  machine.width_m = 6;
  PlanSettings settings;
  std::array<Plan, 3> plans;
  const std::array shapes{TrackShape::kStraight, TrackShape::kCurved, TrackShape::kAuto};
  for (std::size_t i = 0; i < shapes.size(); ++i) {
    settings.shape = shapes[i];
    plans[i] = plan_field(field, machine, Objective{}, settings, 1);
    const check::Verdict verdict = check::verify(plans[i]);
    for (const check::Violation& v : verdict.violations) ADD_FAILURE() << name(v.rule) << ": " << v.what;
  }
  const Plan& best = plans[2];
  EXPECT_STREQ(kind_of_tracks(plans[1]), "curved");
  EXPECT_STREQ(kind_of_tracks(best), "straight and curved");
  EXPECT_EQ(best.subfields.size(), 2U);
  EXPECT_EQ(best.tally.pieces, 21);
  EXPECT_LT(best.cost, 20 + 5 + 1.5) << "turns, a second subfield";
  EXPECT_LT(best.cost, plans[0].cost);
  EXPECT_LT(best.cost, plans[1].cost);
}

/// 100 × 60 m with a pole on a track's line.
Field field_with_a_pole() {
  Field field;
  field.id = "pole";
  field.outer = {{0, 0}, {100, 0}, {100, 60}, {0, 60}};
  field.obstacles = {{{{{50, 31}, {50.4, 31}, {50.4, 31.4}, {50, 31.4}}, {}}, ObstacleKind::kObstacle, ""}};
  return field;
}

/// Whether check takes the plan for that request; nullopt where the request is refused.
std::optional<bool> holds(const Machine& machine, const PlanSettings& settings) {
  try {
    return check::verify(plan_field(field_with_a_pole(), machine, {}, settings, 1)).holds();
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::kBadInput) << error.what();
    return std::nullopt;
  }
}

// A length is refused before planning, or the plan made with it holds: never planned and then refused.
TEST(PlannedPlans, HoldUpToTheLargestRadius) {
  EXPECT_EQ(holds({"", 3, kFarthest_m, -1}, {}), true);
  EXPECT_EQ(holds({"", 3, std::nextafter(kFarthest_m, 1e8), -1}, {}), std::nullopt);
  EXPECT_EQ(holds({"", 3, 1e308, -1}, {}), std::nullopt);
}

TEST(PlannedPlans, HoldOrAreRefusedWhateverTheLengths) {
  for (const double length_m : {1e3, 1e6, kFarthest_m, 1e8, 1e154, 1e308}) {
    SCOPED_TRACE(length_m);
    PlanSettings threshold, clearance;
    threshold.avoid = Avoidance::kPaper;
    threshold.avoid_threshold_m = length_m;
    clearance.clearance_m = length_m;
    const bool sensible = length_m <= kFarthest_m;
    EXPECT_NE(holds({"", length_m, 6, 0}, {}), false);
    EXPECT_EQ(holds({"", 3, 6, length_m}, {}), std::nullopt) << "no piece is that long";
    EXPECT_EQ(holds({"", 3, 6, -1}, threshold), sensible ? std::optional(true) : std::nullopt);
    EXPECT_EQ(holds({"", 3, 6, -1}, clearance), std::nullopt) << "no ground is that far from the pole";
  }
}

// Zhou's own tracks have kinks, which is all that is found where nothing is worked again. They hold, for the
// figures are true: cells of swaths counted one by one against outlines of whole ones.
TEST(PlannedPlans, WithKinksHoldAndAreFoundUndrivable) {
  Field field;
  field.id = "bends";
  field.outer = {{0, 0}, {90, 10}, {170, -25}, {260, 5}, {250, 120}, {160, 90}, {70, 130}, {-10, 110}};
  field.obstacles.push_back(
      {{{{60, 60}, {75, 58}, {80, 72}, {62, 75}}, {}}, ObstacleKind::kObstacle, "pond"});
  PlanSettings settings;
  settings.tracks = TrackConstruction::kPaper;
  settings.shape = TrackShape::kCurved;
  settings.end_rule = EndRule::kCover;
  settings.headlands = settings.obstacle_headlands = 1;
  settings.guide = {{0, 0}, {90, 10}, {170, -25}, {260, 5}};
  const Plan plan = plan_field(field, {"", 4, 6, 0}, {}, settings, 1);
  const check::Verdict verdict = check::verify(plan);
  EXPECT_TRUE(verdict.holds());
  EXPECT_FALSE(verdict.findings.empty());
  for (const check::Violation& each : verdict.findings)
    EXPECT_EQ(each.rule, check::Rule::kDrivable) << each.what;
}

}  // namespace tramline::planned_plans_test
