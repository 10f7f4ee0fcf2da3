#include "tramline/coverage/drive/plan_steps.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "tramline/coverage/deviation.h"
#include "tramline/geometry/path/path.h"

namespace tramline::coverage {
namespace {

Plan plan_with(std::vector<TrackPiece> pieces) {
  Plan plan;
  plan.machine.width_m = 4;
  plan.pieces = std::move(pieces);
  return plan;
}

double gross_m2(const std::vector<WorkedStep>& steps) {
  double sum = 0;
  for (const WorkedStep& step : steps)
    for (const Quad& quad : step.quads) sum += std::abs(signed_area(Ring(quad.begin(), quad.end())));
  return sum;
}

TEST(PlanSteps, APieceIsARunOfItsOwn) {
  const std::vector<WorkedStep> steps = plan_steps(plan_with({{{0, 0}, {10, 0}}, {{10, 4}, {0, 4}}}));
  ASSERT_EQ(steps.size(), 2U);
  EXPECT_EQ(steps[0].quads.at(0), (Quad{{{0, 2}, {0, -2}, {10, -2}, {10, 2}}}));
  EXPECT_EQ(steps[1].quads.at(0), (Quad{{{10, 2}, {10, 6}, {0, 6}, {0, 2}}}));
  EXPECT_EQ(steps[1].run, 1);
  EXPECT_DOUBLE_EQ(steps[1].travel_m, 10);
}

// A quarter circle of radius 6: 3π long, 4 wide.
TEST(PlanSteps, AnArcIsWorkedAsItIs) {
  TrackPiece arc{{0, 0}, {6, 6}};
  arc.curve = {{{0, 0}, {6, 6}, 1.0 / 6}};
  const std::vector<WorkedStep> steps = plan_steps(plan_with({arc}));
  EXPECT_NEAR(gross_m2(steps), 3 * std::numbers::pi * 4, 1e-4);
  EXPECT_NEAR(steps.back().travel_m, 3 * std::numbers::pi, 1e-5);
}

// Half of the way on the track, a quarter 0.5 m beside it, a quarter 3 m beside it and so along none.
TEST(Deviation, IsWeightedByTheWay) {
  const Plan plan = plan_with({{{0, 0}, {100, 0}}});
  const Deviation found = deviation(plan, {{0, {{0, 0}, {25, 0}, {50, 0}}},
                                           {1, {{50, 0.5}, {75, 0.5}}},
                                           {2, {{75, 3}, {100, 3}}},
                                           {-1, {{0, 1}, {100, 1}}}});
  EXPECT_NEAR(found.along_m, 75, 1e-9);
  EXPECT_NEAR(found.beside_m, 25, 1e-9);
  EXPECT_NEAR(found.mean_m, 0.5 * 25 / 75, 1e-9);
  EXPECT_NEAR(found.p95_m, 0.5, 1e-9);
  EXPECT_NEAR(found.most_m, 0.5, 1e-9);
}

// Tracks eastwards every 4 m, and a drive northwards over them: within half a width of one wherever it is,
// and 90° off its direction. A quarter of its way is along a track.
TEST(Deviation, APlanInAnotherDirectionIsNotFollowed) {
  const Plan plan = plan_with({{{0, 0}, {100, 0}}, {{0, 4}, {100, 4}}, {{0, 8}, {100, 8}}});
  const Deviation across = deviation(plan, {{0, {{50, 0}, {50, 3}, {50, 6}}}, {1, {{10, 4.5}, {12, 4.5}}}});
  EXPECT_NEAR(across.along_m, 2, 1e-9);
  EXPECT_NEAR(across.beside_m, 6, 1e-9);
  EXPECT_NEAR(across.followed_share(), 0.25, 1e-9);
  EXPECT_FALSE(across.followed());
  EXPECT_NEAR(across.median_angle_deg, 90, 1e-6);
  const Deviation along = deviation(plan, {{0, {{10, 4.5}, {12, 4.5}}}});
  EXPECT_TRUE(along.followed());
  EXPECT_NEAR(along.median_distance_m, 0.5, 1e-9);
}

// 10° off is along the track, 20° is not.
TEST(Deviation, FollowingHasALimitInDirection) {
  const Plan plan = plan_with({{{-50, 0}, {50, 0}}});
  for (const double degrees : {10.0, 20.0}) {
    const double angle = degrees * std::numbers::pi / 180;
    const Point step{std::cos(angle), std::sin(angle)};
    EXPECT_EQ(deviation(plan, {{0, {-1.0 * step, step}}}).followed(), degrees < 15);
  }
}

// Far from all tracks the distance is still known.
TEST(Deviation, ADriveElsewhereIsSoFarOff) {
  const Plan plan = plan_with({{{0, 0}, {100, 0}}});
  const Deviation far = deviation(plan, {{0, {{50, 300}, {60, 300}}}});
  EXPECT_FALSE(far.followed());
  EXPECT_NEAR(far.median_distance_m, 300, 1e-9);
  EXPECT_NEAR(far.median_angle_deg, 0, 1e-6);
}

HeadlandPass pass_along(Point from, Point to) {
  HeadlandPass out;
  out.path = straight_path(from, to);
  return out;
}

TEST(PlanSteps, HeadlandPassesAreWorkedAfterThePieces) {
  Plan plan = plan_with({{{0, 0}, {10, 0}}});
  plan.headland.passes = {pass_along({0, 10}, {20, 10})};
  const std::vector<WorkedStep> steps = steps_of(plan);
  EXPECT_NEAR(gross_m2(steps), 4 * 30, 1e-9);
  EXPECT_EQ(steps.back().run, 1);
}

RouteLeg working(LegKind kind, Point from, double heading_deg, double length_m) {
  RouteLeg out{kind, Gear::kForward, true};
  const Heading heading = Heading::clockwise_from_north(Angle::degrees(heading_deg));
  out.path = {arc_from({from, heading}, length_m, 0, Gear::kForward)};
  return out;
}

RouteLeg along_piece(std::size_t piece, Point from, double heading_deg, double length_m) {
  RouteLeg out = working(LegKind::kWork, from, heading_deg, length_m);
  out.piece = piece;
  return out;
}

RouteLeg along_pass(std::size_t pass, Point from, double heading_deg, double length_m) {
  RouteLeg out = working(LegKind::kHeadland, from, heading_deg, length_m);
  out.pass = pass;
  return out;
}

RouteLeg with_work_off(Point from, double heading_deg, double length_m) {
  RouteLeg out = working(LegKind::kTransit, from, heading_deg, length_m);
  out.work = false;
  return out;
}

// The pass comes first and is driven westwards, then the second piece, then the first against its own sense.
// Ways between them work nothing.
TEST(PlanSteps, ARouteIsDrivenInItsOrderAndSense) {
  Plan plan = plan_with({{{0, 0}, {10, 0}}, {{0, 4}, {10, 4}}});
  plan.headland.passes = {pass_along({0, 10}, {20, 10})};
  const double without_route_m2 = gross_m2(steps_of(plan));
  plan.route.legs = {along_pass(0, {20, 10}, 270, 20), with_work_off({0, 10}, 180, 6),
                     along_piece(1, {0, 4}, 90, 10), with_work_off({10, 4}, 180, 4),
                     along_piece(0, {10, 0}, 270, 10)};
  const std::vector<PlanRun> runs = runs_of(plan);
  ASSERT_EQ(runs.size(), 3U);
  EXPECT_EQ(runs[0].run, 2);
  EXPECT_EQ(runs[0].path, straight_path({20, 10}, {0, 10}));
  EXPECT_EQ(runs[1].run, 1);
  EXPECT_EQ(runs[1].path, straight_path({0, 4}, {10, 4}));
  EXPECT_EQ(runs[2].run, 0);
  EXPECT_EQ(runs[2].path, straight_path({10, 0}, {0, 0}));
  const std::vector<WorkedStep> steps = steps_of(plan);
  ASSERT_EQ(steps.size(), 3U);
  EXPECT_EQ(steps[0].run, 2);
  EXPECT_EQ(steps[0].quads.at(0), (Quad{{{20, 8}, {20, 12}, {0, 12}, {0, 8}}}));
  EXPECT_EQ(steps[2].run, 0);
  EXPECT_EQ(steps[2].quads.at(0), (Quad{{{10, -2}, {10, 2}, {0, 2}, {0, -2}}}));
  for (std::size_t i = 0; i < steps.size(); ++i) EXPECT_EQ(steps[i].fix, i);
  EXPECT_NEAR(gross_m2(steps), without_route_m2, 1e-9);
}

// The axle is 7 m ahead of the implement, and beyond the middle of the piece when the work begins.
TEST(PlanSteps, TheSenseIsThatOfTheImplement) {
  Plan plan = plan_with({{{0, 0}, {10, 0}}});
  plan.machine.turning.implement_offset_m = 7;
  plan.route.legs = {along_piece(0, {7, 0}, 90, 10)};
  EXPECT_EQ(runs_of(plan).at(0).path, straight_path({0, 0}, {10, 0}));
  plan.route.legs = {along_piece(0, {3, 0}, 270, 10)};
  EXPECT_EQ(runs_of(plan).at(0).path, straight_path({10, 0}, {0, 0}));
}

/// Counter-clockwise: 20 m east, half a circle of 5 m, 20 m west, half a circle.
HeadlandPass stadium() {
  HeadlandPass out;
  out.path = {{{0, 0}, {20, 0}, 0}, {{20, 0}, {20, 10}, 0.2}, {{20, 10}, {0, 10}, 0}, {{0, 10}, {0, 0}, 0.2}};
  return out;
}

double round_m() { return 40 + 10 * std::numbers::pi; }

// Entered at the axle's (12, 0) driving west, with the implement 2 m behind: at (14, 0).
TEST(PlanSteps, AClosedPassBeginsWhereTheRouteEntersIt) {
  Plan plan = plan_with({});
  plan.machine.turning.implement_offset_m = 2;
  plan.headland.passes = {stadium()};
  const double without_route_m2 = gross_m2(steps_of(plan));
  plan.route.legs = {along_pass(0, {12, 0}, 270, 12)};
  const Path path = runs_of(plan).at(0).path;
  ASSERT_EQ(path.size(), 5U);
  EXPECT_NEAR(distance(path.front().from, {14, 0}), 0, 1e-9);
  EXPECT_NEAR(distance(path.front().to, {0, 0}), 0, 1e-9);
  EXPECT_NEAR(distance(path.back().to, {14, 0}), 0, 1e-9);
  EXPECT_NEAR(length(path), round_m(), 1e-9);
  EXPECT_NEAR(gross_m2(steps_of(plan)), without_route_m2, 1e-9);
}

// On the eastern half circle, a quarter of a circle on, with the axle in the same place: (25, 5), northwards.
TEST(PlanSteps, AClosedPassMayBeEnteredOnAnArc) {
  Plan plan = plan_with({});
  plan.headland.passes = {stadium()};
  plan.route.legs = {along_pass(0, {25, 5}, 0, 12)};
  const Path path = runs_of(plan).at(0).path;
  EXPECT_NEAR(distance(path.front().from, {25, 5}), 0, 1e-9);
  EXPECT_NEAR(distance(path.front().to, {20, 10}), 0, 1e-9);
  EXPECT_NEAR(length(path), round_m(), 1e-9);
}

// What a route leaves out is part of the plan still; a pass in several legs is one run.
TEST(PlanSteps, EveryPieceAndPassIsDrivenOnce) {
  Plan plan = plan_with({{{0, 0}, {10, 0}}, {{0, 4}, {10, 4}}});
  plan.headland.passes = {pass_along({0, 10}, {20, 10})};
  RouteLeg across = with_work_off({8, 10}, 90, 2);
  across.pass = 0;
  plan.route.legs = {along_pass(0, {0, 10}, 90, 8), across, along_pass(0, {10, 10}, 90, 10),
                     along_piece(1, {0, 4}, 90, 10), along_piece(7, {0, 0}, 90, 10)};
  const std::vector<PlanRun> runs = runs_of(plan);
  ASSERT_EQ(runs.size(), 3U);
  EXPECT_EQ(runs[0].run, 2);
  EXPECT_EQ(runs[0].path, straight_path({0, 10}, {20, 10}));
  EXPECT_EQ(runs[1].run, 1);
  EXPECT_EQ(runs[2].run, 0);
}

// A ditch 2 m wide that leads over the pass on a slant: 2 · 4·√2 m² of it are not worked, the rest is, once.
TEST(PlanSteps, OnAPassableObstacleTheHeadlandPassIsInterrupted) {
  Plan plan = plan_with({});
  plan.headland.passes = {pass_along({0, 0}, {20, 0})};
  const double half = std::numbers::sqrt2;  // along the pass: half of 2 m across a ditch at 45°
  plan.field.obstacles = {{{{{5 - half, -5}, {5 + half, -5}, {15 + half, 5}, {15 - half, 5}}, {}},
                           ObstacleKind::kPassable,
                           "ditch"}};
  EXPECT_NEAR(gross_m2(headland_steps(plan, 0)), 80 - 2 * 4 * std::numbers::sqrt2, 1e-9);
}

}  // namespace
}  // namespace tramline::coverage
