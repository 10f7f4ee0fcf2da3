// Plans that hold, with figures known by hand.

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "check/plans.h"
#include "tramline/geometry/polygon/boolean.h"
#include "tramline/geometry/strip/track_frame.h"

namespace tramline {
namespace {

using namespace testing_plans;

TEST(HoldingPlans, RectangleIsCoveredExactlyUnderEveryEndRule) {
  Plan plan = rectangle_plan();
  for (const EndRule rule : {EndRule::kCentre, EndRule::kCover, EndRule::kInside, EndRule::kCheapest})
    for (const EdgeKind boundary : {EdgeKind::kSoft, EdgeKind::kHard}) {
      plan.settings.end_rule = rule;
      plan.settings.boundary = boundary;
      expect_holds(plan);
    }
  EXPECT_NEAR(plan.tally.overlap_m2, 0, 1e-6);
  EXPECT_NEAR(plan.tally.uncovered_m2, 0, 1e-6);
  EXPECT_DOUBLE_EQ(plan.tally.worked_m2, 3000);
  EXPECT_EQ(plan.tally.turns, 9);
  EXPECT_EQ(plan.tally.stops, 0);
}

/// Each oblique end overlaps ½·w²·cot φ·(1−f)² and misses ½·w²·cot φ·f².
TEST(HoldingPlans, TriangleWithCentreEnds) {
  const Plan plan = triangle_plan(EndRule::kCentre, 0.5);
  expect_holds(plan);
  EXPECT_NEAR(plan.tally.overlap_m2, 10 * 5.0, 1e-4);
  EXPECT_NEAR(plan.tally.uncovered_m2, 10 * 5.0, 1e-4);
}

TEST(HoldingPlans, TriangleWithCheapestEnds) {
  const double f = cheapest_share(Objective{});
  const Plan plan = triangle_plan(EndRule::kCheapest, f);
  expect_holds(plan);
  EXPECT_NEAR(plan.tally.overlap_m2, 10 * 20 * (1 - f) * (1 - f), 1e-4);
  EXPECT_NEAR(plan.tally.uncovered_m2, 10 * 20 * f * f, 1e-4);
}

TEST(HoldingPlans, TriangleWithCoveringAndInnerEnds) {
  const Plan cover = triangle_plan(EndRule::kCover, 0);
  expect_holds(cover);
  EXPECT_NEAR(cover.tally.overlap_m2, 200, 1e-4);
  EXPECT_NEAR(cover.tally.uncovered_m2, 0, 1e-4);
  const Plan inside = triangle_plan(EndRule::kInside, 1);
  expect_holds(inside);
  EXPECT_EQ(inside.tally.pieces, 9);
  EXPECT_NEAR(inside.tally.overlap_m2, 0, 1e-4);
  EXPECT_NEAR(inside.tally.uncovered_m2, 200, 1e-4);
}

TEST(HoldingPlans, ObstacleCutsTwoSwaths) {
  const Plan plan = obstacle_plan();
  expect_holds(plan);
  EXPECT_EQ(plan.tally.pieces, 12);
  EXPECT_EQ(plan.tally.turns, 11);
  EXPECT_EQ(plan.tally.stops, 4);
  EXPECT_NEAR(plan.tally.uncovered_m2, 2 * 60 - 40, 1e-4);
  EXPECT_NEAR(plan.tally.overlap_m2, 0, 1e-4);
}

TEST(HoldingPlans, SubfieldsMayWorkEachOthersBorder) {
  const Plan plan = two_subfields_plan();
  expect_holds(plan);
  EXPECT_NEAR(plan.tally.overlap_m2, 2 * 10 * 3.0, 1e-4);
  EXPECT_NEAR(plan.tally.uncovered_m2, 0, 1e-4);
}

TEST(HoldingPlans, CrossingsAreNeitherTurnsNorStops) {
  const Plan plan = crossing_plan();
  expect_holds(plan);
  EXPECT_EQ(plan.tally.pieces, 20);
  EXPECT_EQ(plan.tally.crossings, 10);
  EXPECT_EQ(plan.tally.turns, 9);
  EXPECT_EQ(plan.tally.stops, 0);
}

TEST(HoldingPlans, ShortPiecesBesideACrossingAreExempt) {
  Plan plan = crossing_plan();
  plan.machine.min_length_m = 50;
  expect_holds(plan);
}

TEST(HoldingPlans, LandGivenUpCountsAsUncoveredAndStopsTheMachine) {
  const Plan plan = given_up_plan();
  expect_holds(plan);
  EXPECT_EQ(plan.tally.stops, 4);
  EXPECT_NEAR(plan.tally.uncovered_m2, 2 * 60, 1e-4);
}

TEST(HoldingPlans, APlanWithoutPiecesMissesEverything) {
  Plan plan = rectangle_plan();
  plan.pieces.clear();
  plan = settled(plan);
  expect_holds(plan);
  EXPECT_DOUBLE_EQ(plan.tally.uncovered_m2, 3000);
  EXPECT_EQ(plan.tally.turns, 0);
}

Ring moved(const Ring& ring, const TrackFrame& frame, Point by) {
  Ring out;
  for (const Point p : ring) out.push_back(frame.to_field(p) + by);
  return out;
}

/// The same plan turned by some odd angle and moved away holds as well: nothing depends on the axes.
TEST(HoldingPlans, TurningAndMovingChangesNothing) {
  for (const double degrees : {1.0, 33.3, 89.99, 122.4}) {
    Plan plan = triangle_plan(EndRule::kCheapest, cheapest_share(Objective{}));
    const TrackFrame frame(Direction::clockwise_from_north(Angle::degrees(degrees)));
    const Point by{-712.3, 455.1};
    plan.field.outer = moved(plan.field.outer, frame, by);
    plan.body = {{plan.field.outer, {}}};
    plan.subfields = {{plan.body[0], Direction::clockwise_from_north(Angle::degrees(90 + degrees))}};
    plan.uncovered.clear();
    for (TrackPiece& piece : plan.pieces) {
      piece.start = frame.to_field(piece.start) + by;
      piece.end = frame.to_field(piece.end) + by;
    }
    const Tally before = plan.tally;
    plan = settled(plan);
    expect_holds(plan);
    EXPECT_NEAR(plan.tally.overlap_m2, before.overlap_m2, 1e-3);
    EXPECT_NEAR(plan.tally.uncovered_m2, before.uncovered_m2, 1e-3);
  }
}

/// A round field of 1,300 vertices with 600 swaths and 20 round obstacles.
TEST(HoldingPlans, LargePlansAreJudged) {
  Plan plan;
  const auto circle = [](Point centre, double radius, int n) {
    Ring out;
    for (int i = 0; i < n; ++i) {
      const double t = 2 * std::numbers::pi * i / n;
      out.push_back(centre + radius * Point{std::cos(t), std::sin(t)});
    }
    return out;
  };
  plan.field.outer = circle({}, 600, 1300);
  plan.machine.width_m = 2;
  for (int i = 0; i < 20; ++i) {
    const Ring obstacle = circle({50.0 * (i - 10) + 20, 13.0 * (i - 10)}, 5, 40);
    plan.field.obstacles.push_back({{obstacle, {}}, ObstacleKind::kObstacle, "tree"});
  }
  Region obstacles;
  for (const Obstacle& obstacle : plan.field.obstacles) obstacles.push_back(obstacle.shape);
  plan.body = difference({{plan.field.outer, {}}}, obstacles);
  plan.subfields = {{plan.body[0], Direction::clockwise_from_north(Angle::degrees(0))}};
  for (int i = 0; i < 600; ++i) {
    const double x = -599 + 2 * i, half = std::sqrt(600.0 * 600 - x * x);
    plan.pieces.push_back({{x, -half}, {x, half}, 0, i});
  }
  EXPECT_TRUE(check::verify(plan).complete);
}

}  // namespace
}  // namespace tramline
