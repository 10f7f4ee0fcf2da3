// Versleijen's obstacle categories b and c on scenes with areas known by hand; working width 3 m.

#include "tramline/avoidance/obstacles/obstacle_classification.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "tramline/avoidance/obstacles/clusters.h"
#include "tramline/geometry/polygon/boolean.h"

namespace tramline::obstacle_classification_test {

constexpr double kWidth = 3;

Polygon box(double x0, double y0, double x1, double y1) {
  return {{{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}}, {}};
}

Field field_with(std::vector<Polygon> obstacles) {
  Field field;
  field.outer = box(0, 0, 100, 100).outer;
  for (Polygon& shape : obstacles)
    field.obstacles.push_back({std::move(shape), ObstacleKind::kObstacle, "hole"});
  return field;
}

// b: squares of 4 m whose faces are 2 m apart: the 2 × 4 m between them are given up.
TEST(Clusters, GiveUpTheLandBetween) {
  const ClassifiedGround ground =
      classify_obstacles(field_with({box(40, 40, 44, 44), box(46, 40, 50, 44)}), kWidth);
  EXPECT_NEAR(area(ground.given_up), 8, 1e-6);
  EXPECT_NEAR(area(ground.body), 10000 - 32, 1e-6) << "given-up land stays in the body";
  EXPECT_NEAR(area(ground.plannable), 10000 - 40, 1e-6);
  EXPECT_EQ(ground.hard.size(), 1u) << "one obstacle";
}

TEST(Clusters, LeaveObstaclesAWidthApartAlone) {
  const ClassifiedGround ground =
      classify_obstacles(field_with({box(40, 40, 44, 44), box(47, 40, 51, 44)}), kWidth);
  EXPECT_TRUE(ground.given_up.empty());
  EXPECT_EQ(ground.hard.size(), 2u);
}

TEST(Clusters, AreTransitive) {
  const auto groups =
      clusters({box(0, 0, 1, 1), box(30, 0, 31, 1), box(5, 0, 6, 1), box(2.5, 0, 3.5, 1)}, kWidth);
  ASSERT_EQ(groups.size(), 2u);
  EXPECT_EQ(groups[0].obstacles.size(), 3u);
}

TEST(Clusters, JoinCornerToCorner) {
  // Corners √2 apart: one obstacle, although no face looks at another.
  const ClassifiedGround ground =
      classify_obstacles(field_with({box(40, 40, 44, 44), box(45, 45, 49, 49)}), kWidth);
  EXPECT_EQ(ground.hard.size(), 1u);
}

// c: a square of 4 m, 2 m from the lower edge: the 4 × 2 m between are given up.
TEST(EdgeClips, GiveUpTheLandUpToTheEdge) {
  const ClassifiedGround ground = classify_obstacles(field_with({box(40, 2, 44, 6)}), kWidth);
  EXPECT_NEAR(area(ground.given_up), 8, 1e-6);
  ASSERT_EQ(ground.plannable.size(), 1u);
  EXPECT_TRUE(ground.plannable[0].holes.empty()) << "the obstacle is joined to the edge";
  EXPECT_NEAR(area(ground.plannable), 10000 - 4 * 6, 1e-6);
}

TEST(EdgeClips, ApplyToObstaclesThatTouchTheEdge) {
  const ClassifiedGround ground = classify_obstacles(field_with({box(40, 0, 44, 4)}), kWidth);
  EXPECT_NEAR(area(ground.given_up), 0, 1e-6);
  EXPECT_NEAR(area(ground.hard), 16, 1e-6);
  EXPECT_TRUE(ground.plannable[0].holes.empty());
}

// The tip of a diamond lies 1 cm inside a square: a common square centimetre, which admission leaves alone.
TEST(EdgeClips, TakeObstaclesThatAllButTouch) {
  const Polygon diamond{{{43.99, 4}, {46, 2}, {48, 4}, {46, 6}}, {}};
  const ClassifiedGround ground = classify_obstacles(field_with({box(40, 2, 44, 6), diamond}), kWidth);
  // Below the square 4 × 2 m; below the diamond what lies within 3 m of the edge, below y = 3.
  const Region below{box(40, 0, 44, 2)};
  EXPECT_NEAR(area(intersection(ground.given_up, below)), 8, 1e-3);
  EXPECT_GT(area(intersection(ground.given_up, {box(45, 0, 47, 2)})), 4 - 1e-3);
  EXPECT_EQ(ground.hard.size(), 1u);
}

TEST(EdgeClips, LeaveObstaclesAWidthFromTheEdgeAlone) {
  EXPECT_TRUE(classify_obstacles(field_with({box(40, 3, 44, 6)}), kWidth).given_up.empty());
}

TEST(EdgeClips, ReachThroughAClusterToTheEdge) {
  // The first square is joined to the edge, the second to the first: 4·2 + 4·2 m².
  const ClassifiedGround ground =
      classify_obstacles(field_with({box(40, 2, 44, 6), box(40, 8, 44, 12)}), kWidth);
  EXPECT_NEAR(area(ground.given_up), 16, 1e-6);
  EXPECT_EQ(ground.hard.size(), 1u);
}

// A metre kept clear round a square of 4 m at the edge: outside 4 m² and two quarter discs, whose chords lie
// outside the circle by up to 1/cos²(3π/128) of its area; inside 3 sides and two quarter discs more.
TEST(Clearance, IsKeptOutsideTheFieldToo) {
  const ClassifiedGround ground = classify_obstacles(field_with({box(40, 0, 44, 4)}), kWidth, 1);
  const double quarters = std::numbers::pi / 2;
  const auto expect_area = [quarters](const Region& land, double straight) {
    EXPECT_GE(area(land), straight + quarters - 1e-6);
    EXPECT_LE(area(land), (straight + quarters) * 1.0055);
  };
  expect_area(ground.beyond, 4);
  expect_area(ground.given_up, 12);
  ASSERT_EQ(ground.hazards.size(), 1u);
  EXPECT_NEAR(bounds(ground.hazards[0].shape).min_y, -1, 0.003);
  EXPECT_NEAR(bounds(ground.plannable).min_y, 0, 1e-6);
  EXPECT_TRUE(classify_obstacles(field_with({box(40, 10, 44, 14)}), kWidth, 1).beyond.empty());
}

// Regular poles with corners of every angle.
TEST(Clearance, IsKeptAtEveryCorner) {
  for (int corners = 3; corners < 100; ++corners) {
    Polygon pole;
    for (int i = 0; i < corners; ++i) {
      const double angle = 2 * std::numbers::pi * i / corners;
      pole.outer.push_back({50 + 2 * std::cos(angle), 50 + 2 * std::sin(angle)});
    }
    const ClassifiedGround ground = classify_obstacles(field_with({pole}), kWidth, 2);
    ASSERT_EQ(ground.hard.size(), 1u);
    EXPECT_GE(distance_to_ring({pole}, ground.hard[0].outer), 2 - 1e-6) << corners;
    EXPECT_LE(bounds(ground.hard).width(), 8 * 1.0055) << corners;
  }
}

// The 3 m kept clear reach over a ditch of 1 m: beyond it lies one metre more.
TEST(Clearance, BelongsToItsObstacleBeyondPassableLand) {
  Field field = field_with({box(40, 40, 44, 44)});
  field.obstacles.push_back({box(45, 0, 46, 100), ObstacleKind::kPassable, "ditch"});
  const ClassifiedGround ground = classify_obstacles(field, kWidth, 3);
  ASSERT_EQ(ground.hazards.size(), 2u);
  for (const Hazard& hazard : ground.hazards) EXPECT_EQ(hazard.obstacles, std::vector<std::size_t>{0});
}

// A hedge all round a garden of 10 × 10 m: no machine gets into the garden.
TEST(EnclosedLand, IsGivenUp) {
  Field field = field_with({});
  Polygon hedge = box(40, 40, 54, 54);
  hedge.holes = {reversed(box(42, 42, 52, 52).outer)};
  field.obstacles.push_back({hedge, ObstacleKind::kObstacle, "hedge"});
  const ClassifiedGround ground = classify_obstacles(field, kWidth);
  EXPECT_NEAR(area(ground.given_up), 100, 1e-6);
  EXPECT_NEAR(area(ground.plannable), 10000 - 14 * 14, 1e-6);
  EXPECT_NEAR(area(ground.body), 10000 - 14 * 14 + 100, 1e-6);
}

TEST(PassableObstacles, AreTakenOutOfTheBodyButStayPlannable) {
  Field field = field_with({});
  field.obstacles.push_back({box(0, 50, 100, 55), ObstacleKind::kPassable, "waterway"});
  const ClassifiedGround ground = classify_obstacles(field, kWidth);
  EXPECT_NEAR(area(ground.body), 9500, 1e-6);
  EXPECT_NEAR(area(ground.plannable), 10000, 1e-6);
  EXPECT_TRUE(ground.hard.empty());
}

}  // namespace tramline::obstacle_classification_test
