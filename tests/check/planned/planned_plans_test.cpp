// What the planner makes holds: closed forms on one road, polygon booleans on the other.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "properties/random_field.h"
#include "properties/seeds.h"
#include "tramline/check/verify.h"
#include "tramline/geometry/error.h"
#include "tramline/geometry/path/path.h"
#include "tramline/geometry/polygon/boolean.h"
#include "tramline/model/limits.h"
#include "tramline/planner/plan_field.h"

namespace tramline {
namespace {

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

/// 120 × 90 m with a mast of 1.2 m radius, 64 corners, on the line of the eleventh track of 3 m.
Plan round_a_mast(Avoidance avoid, double radius_m, double room_m = -1) {
  Field field;
  field.id = "mast";
  field.outer = {{0, 0}, {120, 0}, {120, 90}, {0, 90}};
  Ring mast;
  for (int i = 0; i < 64; ++i) {
    const double angle = -2 * std::numbers::pi * i / 64;
    mast.push_back({60 + 1.2 * std::cos(angle), 31.5 + 1.2 * std::sin(angle)});
  }
  field.obstacles.push_back({{mast, {}}, ObstacleKind::kObstacle, "mast"});
  PlanSettings settings;
  settings.strategy = Strategy::kSweep;
  settings.avoid = avoid;
  settings.avoid_room_m = room_m;
  return plan_field(field, {"", 3, radius_m, -1}, weights_of(Scenario::kTurns), settings, 1);
}

// Versleijen fig. 18: the middle arc has the radius R + w/2 = 2.7 m, whatever the machine turns on. The
// verifier says so, and the plan holds.
TEST(PlannedPlans, FindTightMiddlesOfThePapersDetoursAndHold) {
  for (const double radius_m : {2.0, 6.0, 12.0}) {
    SCOPED_TRACE(radius_m);
    const Plan plan = round_a_mast(Avoidance::kPaper, radius_m);
    const check::Verdict verdict = check::verify(plan);
    EXPECT_TRUE(verdict.holds());
    ASSERT_EQ(verdict.findings.size(), radius_m > 2.7 ? 1u : 0u);
    if (verdict.findings.empty()) continue;
    EXPECT_EQ(verdict.findings.front().rule, check::Rule::kDrivable);
    EXPECT_NEAR(verdict.findings.front().amount, radius_m - 2.7, 1e-5);
    EXPECT_NEAR(distance(verdict.findings.front().at, {60, 31.5}), 0, 2.7);
  }
}

// The same arcs are violations where the plan promises that its tracks can be driven, and so are arcs at the
// ends of a paper's detour.
TEST(PlannedPlans, DoNotHoldWhereTightArcsAreNoPapers) {
  Plan plan = round_a_mast(Avoidance::kPaper, 6);
  plan.settings.avoid = Avoidance::kCheapest;
  EXPECT_FALSE(check::verify(plan).holds());
  Plan tighter_ends = round_a_mast(Avoidance::kPaper, 6);
  tighter_ends.machine.radius_m = 7;
  const check::Verdict verdict = check::verify(tighter_ends);
  EXPECT_FALSE(verdict.holds());
  EXPECT_EQ(verdict.violations.size(), 2u) << "arcs of 6 m before and behind";
}

// Versleijen fig. 50 (a): with half the width of room no detour of 2.7 m is driven.
TEST(PlannedPlans, CutWhereADetourHasNoRoom) {
  const Plan plan = round_a_mast(Avoidance::kPaper, 6, 1.5);
  EXPECT_TRUE(check::verify(plan).holds());
  ASSERT_EQ(plan.encounters.size(), 1u);
  EXPECT_EQ(plan.encounters.front().chosen, Passing::kCut);
  EXPECT_EQ(plan.encounters.front().left.why_not, "it would leave the track by more than it may");
  EXPECT_NE(round_a_mast(Avoidance::kPaper, 6, 2.71).encounters.front().chosen, Passing::kCut);
}

// A headland goes round the pole in the west alone: tracks end there. One goes round the pole in the east all
// the same, and past both: it is met with both.
TEST(PlannedPlans, HoldWhereADetourLeadsPastAnObstacleWithAHeadland) {
  Field field;
  field.id = "two poles";
  field.outer = {{0, 0}, {200, 0}, {200, 90}, {0, 90}};
  const Ring west{{62.5, 48.8}, {60.6, 50.6}, {58.1, 49.8}, {57.5, 47.2}, {59.4, 45.4}, {61.9, 46.2}};
  const Ring east{{73.6, 48.1}, {72.3, 49.3}, {70.7, 48.8}, {70.3, 47.1}, {71.6, 45.9}, {73.2, 46.4}};
  for (const Ring& ring : {west, east})
    field.obstacles.push_back({{ring, {}}, ObstacleKind::kObstacle, "pole"});
  PlanSettings settings;
  settings.obstacle_headlands = 1;
  const Plan plan = plan_field(field, {"", 6, 6, -1}, {}, settings, 1);
  std::size_t past_both = 0;
  for (const TrackPiece& piece : plan.pieces)
    for (const Detour& detour : piece.detours) past_both += detour.obstacles.size() == 2 ? 1 : 0;
  EXPECT_GE(past_both, 1U) << "the scene shows nothing";
  const check::Verdict verdict = check::verify(plan);
  for (const check::Violation& each : verdict.violations)
    ADD_FAILURE() << name(each.rule) << ": " << each.what;
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

/// A wall, hardly at an angle to the long sides of the field.
Field walled_field() {
  Field out;
  out.id = "walled";
  out.outer = {{0, 0}, {160, 0}, {160, 70}, {0, 70}};
  out.obstacles.push_back(
      {{{{50, 31}, {110, 36}, {110, 38}, {50, 33}}, {}}, ObstacleKind::kObstacle, "wall"});
  return out;
}

/// Between the line of a pass and a ring, m.
double line_to_ring_m(const Path& line, const Ring& ring) {
  double out = std::numeric_limits<double>::infinity();
  for (const PathSegment& segment : line)
    for (std::size_t i = 0; i < ring.size(); ++i)
      out = std::min(out, distance_to_edge(segment, ring[i], ring[(i + 1) % ring.size()]));
  return out;
}

Polygon swath_of(const TrackPiece& piece, double width_m) {
  const Point along = (1 / distance(piece.start, piece.end)) * (piece.end - piece.start);
  const Point beside = 0.5 * width_m * left_of(along);
  return {{piece.start - beside, piece.end - beside, piece.end + beside, piece.start + beside}, {}};
}

// A track that covers its ground up to an oblique edge runs on into the headland beyond, nearly as far as
// that is deep.
TEST(PlannedPlans, KeepTheClearanceBehindAHeadland) {
  constexpr double kWidth_m = 6, kClear_m = 0.8;
  const Field field = walled_field();
  const Polygon& wall = field.obstacles.front().shape;
  PlanSettings settings;
  settings.obstacle_headlands = 1;
  settings.end_rule = EndRule::kCover;
  settings.clearance_m = kClear_m;
  const Plan plan = plan_field(field, {"", kWidth_m, 4}, {}, settings, 1);
  for (const check::Violation& each : check::verify(plan).violations)
    ADD_FAILURE() << name(each.rule) << ": " << each.what;
  ASSERT_EQ(plan.headland.passes.size(), 1U);
  EXPECT_NEAR(line_to_ring_m(plan.headland.passes[0].path, wall.outer), kClear_m + 0.5 * kWidth_m, 1e-5);
  double nearest_m = kWidth_m;
  for (const TrackPiece& piece : plan.pieces)
    nearest_m = std::min(nearest_m, distance_between({swath_of(piece, kWidth_m)}, {wall}));
  EXPECT_GE(nearest_m, kClear_m - 1e-3);
  EXPECT_LT(nearest_m, kClear_m + 0.2 * kWidth_m) << "some track runs on";
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

}  // namespace
}  // namespace tramline
