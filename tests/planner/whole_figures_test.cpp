// Figures of plans with headlands: all swaths and headland passes together, against all land.

#include "tramline/planner/assembly/whole_figures.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "tramline/geometry/polygon/boolean.h"
#include "tramline/headland/body.h"
#include "tramline/planner/plan_field.h"

namespace tramline::whole_figures_test {

Field field_of(Ring outer) {
  Field field;
  field.id = "drawn";
  field.outer = std::move(outer);
  return field;
}

/// 200 × 100 m, and from its lower right corner an arm 120 m long and so wide.
Field with_arm(double arm_m) {
  return field_of({{0, 0}, {320, 0}, {320, arm_m}, {200, arm_m}, {200, 100}, {0, 100}});
}

Machine machine(double width_m, double radius_m) { return {"", width_m, radius_m, -1}; }

/// What the figures have to be, by polygon booleans: the other road.
struct ByPolygons {
  double overlap_m2 = 0, uncovered_m2 = 0;
};

ByPolygons by_polygons(const Plan& plan) {
  const double width_m = plan.machine.width_m;
  Region worked = swaths(plan);
  double worked_m2 = 0;
  for (const TrackPiece& piece : plan.pieces) worked_m2 += width_m * length(piece);
  for (const HeadlandPass& pass : plan.headland.passes) {
    worked_m2 += width_m * length(pass.path);
    for (const PathSegment& segment : pass.path) worked.push_back({band({segment}, width_m), {}});
  }
  const Region land = body_of(plan.field);
  const double covered_m2 = area(intersection(unite(worked), land));
  return {worked_m2 - covered_m2, area(land) - covered_m2};
}

void expect_figures_by_polygons(const Plan& plan) {
  const ByPolygons other = by_polygons(plan);
  const double tolerance_m2 = 1e-5 * area_m2(plan.field);
  EXPECT_NEAR(plan.tally.overlap_m2, other.overlap_m2, tolerance_m2);
  EXPECT_NEAR(plan.tally.uncovered_m2, other.uncovered_m2, tolerance_m2);
  EXPECT_NEAR(identity_error_m2(plan), 0, tolerance_m2);
  EXPECT_DOUBLE_EQ(plan.cost, cost(plan.objective, plan.tally));
  EXPECT_NEAR(area(plan.uncovered), plan.tally.uncovered_m2, 10 * tolerance_m2);
}

// No swath 12 m wide fits into an arm 8 m wide: 120 · 8 = 960 m² are left, and beside its mouth some of the
// headland's corner. They belong to the headland's ground, and count all the same.
TEST(WholeFigures, LandOfTheHeadlandThatNothingWorksCounts) {
  PlanSettings settings;
  settings.headlands = 1;
  const Plan plan = plan_field(with_arm(8), machine(12, 6), {}, settings);
  EXPECT_GE(plan.tally.uncovered_m2, 950);
  EXPECT_GE(plan.cost, 0.10 * 950);
  EXPECT_LT(plan.track_tally.uncovered_m2, 100);
  expect_figures_by_polygons(plan);
  EXPECT_TRUE(std::any_of(plan.warnings.begin(), plan.warnings.end(), [](const std::string& warning) {
    return warning.find("stays unworked") != std::string::npos;
  }));
  const auto narrow = std::ranges::find_if(plan.warnings, [](const std::string& warning) {
    return warning.find("narrower than the machine") != std::string::npos;
  });
  ASSERT_NE(narrow, plan.warnings.end());
  EXPECT_NEAR(std::stod(*narrow), 960, 10) << *narrow;  // what is left beside the mouth is not narrow
}

// Tracks 12 m wide leave corners of more than 2 % of a small field, none of them narrower than a track.
TEST(WholeFigures, LandThatIsNotNarrowIsNotCalledSo) {
  PlanSettings settings;
  settings.headlands = 1;
  const Plan plan = plan_field(field_of({{0, 0}, {60, 0}, {60, 40}, {0, 40}}), machine(12, 6), {}, settings);
  ASSERT_GT(plan.tally.uncovered_m2, 0.02 * 60 * 40);
  for (const std::string& warning : plan.warnings)
    EXPECT_EQ(warning.find("narrower"), std::string::npos) << warning;
}

// A rectangle with one pass: the four corners that the pass rounds are left, each r² − πr²/4 … of the outer
// edge of the swath, whose radius is r + w/2: (1 − π/4) · 7.5² = 12.07 m² at w = 3, r = 6; the inner edge, of
// radius r − w/2 = 4.5, leaves (1 − π/4) · 4.5² = 4.35 m² outside the swath to the body. Tracks end at the
// body.
TEST(WholeFigures, CornersOfAPassAreLeft) {
  PlanSettings settings;
  settings.headlands = 1;
  const Plan plan = plan_field(field_of({{0, 0}, {126, 0}, {126, 66}, {0, 66}}), machine(3, 6), {}, settings);
  expect_figures_by_polygons(plan);
  EXPECT_NEAR(plan.track_tally.uncovered_m2, 0, 1e-3);
  EXPECT_NEAR(plan.tally.uncovered_m2, 4 * (1 - 0.25 * std::numbers::pi) * 7.5 * 7.5, 0.5);
}

TEST(WholeFigures, AreThoseOfPolygonsWhateverTheTracksAre) {
  const Ring crooked{{0, 0}, {150, 12}, {310, 0}, {330, 120}, {200, 170}, {20, 140}};
  for (const int passes : {1, 2})
    for (const TrackShape shape : {TrackShape::kStraight, TrackShape::kCurved, TrackShape::kAuto}) {
      PlanSettings settings;
      settings.headlands = passes;
      settings.shape = shape;
      expect_figures_by_polygons(plan_field(field_of(crooked), machine(6, 6), {}, settings));
    }
}

TEST(WholeFigures, AreThoseOfPolygonsRoundObstacles) {
  Field field = field_of({{0, 0}, {240, 0}, {260, 150}, {0, 160}});
  field.obstacles = {{{{{100, 60}, {130, 60}, {130, 85}, {100, 90}}, {}}, ObstacleKind::kObstacle, "pond"},
                     {{{{180, 20}, {182, 20}, {182, 22}, {180, 22}}, {}}, ObstacleKind::kObstacle, "mast"}};
  for (const int round_obstacles : {0, 1}) {
    PlanSettings settings;
    settings.headlands = 1;
    settings.obstacle_headlands = round_obstacles;
    expect_figures_by_polygons(plan_field(field, machine(6, 6), {}, settings));
  }
}

// Without headlands there is one tally.
TEST(WholeFigures, OfTracksAloneAreTheTracks) {
  const Plan plan = plan_field(with_arm(20), machine(6, 6), {}, {});
  EXPECT_EQ(plan.tally.overlap_m2, plan.track_tally.overlap_m2);
  EXPECT_EQ(plan.tally.uncovered_m2, plan.track_tally.uncovered_m2);
}

// The bound is one on the cost of tracks and passes together.
TEST(WholeFigures, TheBoundDoesNotExceedTheCost) {
  PlanSettings settings;
  for (const int passes : {0, 1, 2}) {
    settings.headlands = passes;
    const Plan plan = plan_field(with_arm(30), machine(6, 6), {}, settings);
    EXPECT_LE(plan.proof.bound, plan.cost);
    EXPECT_LE(plan.proof.one_direction_bound, plan.proof.one_direction_cost);
    EXPECT_GE(plan.proof.one_direction_cost, plan.cost * (1 - 1e-9));
  }
}

}  // namespace tramline::whole_figures_test
