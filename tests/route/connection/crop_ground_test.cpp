// How far ways lead over the land of tracks, against every step looked at by itself.

#include "tramline/route/connection/crop_ground.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "properties/draws.h"
#include "properties/random_field.h"
#include "properties/seeds.h"
#include "tramline/geometry/index/edge_index.h"

namespace tramline {
namespace {

using testing::for_each_seed;

Pose at_deg(Point at, double clockwise_from_north) {
  return {at, Heading::clockwise_from_north(Angle::degrees(clockwise_from_north))};
}

// 100 m by 60 m, with a pond of 20 m by 20 m in its middle.
Region land_with_pond() {
  return {{{{0, 0}, {100, 0}, {100, 60}, {0, 60}}, {{{40, 20}, {40, 40}, {60, 40}, {60, 20}}}}};
}

// From 10 m before the land to 10 m behind it, past the pond and through it: 100 m and 80 m of it are land.
TEST(CropGround, CountsTheLandAlongALine) {
  const CropGround crop(land_with_pond());
  EXPECT_DOUBLE_EQ(crop.length_over_m({arc_from(at_deg({-10, 10}, 90), 120, 0, Gear::kForward)}), 100);
  EXPECT_DOUBLE_EQ(crop.length_over_m({arc_from(at_deg({-10, 30}, 90), 120, 0, Gear::kForward)}), 80);
  EXPECT_DOUBLE_EQ(crop.length_over_m({arc_from(at_deg({110, 30}, 90), 120, 0, Gear::kReverse)}), 80);
}

// Half a circle of 8 m about the middle of the western edge, from south to north: the eastern half lies on
// the land, the western one off it.
TEST(CropGround, CountsTheLandAlongAnArc) {
  const CropGround crop(land_with_pond());
  const double round_m = 8 * std::numbers::pi;
  const Pose south = at_deg({0, 22}, 90);
  EXPECT_DOUBLE_EQ(crop.length_over_m({arc_from(south, round_m, 1.0 / 8, Gear::kForward)}), round_m);
  EXPECT_DOUBLE_EQ(crop.length_over_m({arc_from(south, round_m, 1.0 / 8, Gear::kReverse)}), 0);
}

TEST(CropGround, IsNowhereWithoutLand) {
  EXPECT_EQ(CropGround({}).length_over_m({arc_from(at_deg({0, 0}, 0), 50, 0, Gear::kForward)}), 0);
}

SteeredPath random_path(const Box& over, std::mt19937_64& random) {
  SteeredPath out;
  Pose at =
      at_deg({uniform(random, over.min_x - 20, over.max_x + 20), uniform(random, over.min_y, over.max_y)},
             uniform(random, 0, 360));
  for (int i = any_of(random, 1, 6); i > 0; --i) {
    const double curvature = any_of(random, -1, 1) / uniform(random, 4, 30);
    const double to = any_of(random, 0, 3) == 0 ? 0 : curvature;
    const Gear gear = any_of(random, 0, 3) == 0 ? Gear::kReverse : Gear::kForward;
    out.push_back({at, uniform(random, 0, 90), curvature, to, gear});
    at = end_of(out.back());
  }
  return out;
}

/// Even-odd over all edges in the middle of each step.
double looked_at_step_by_step(const Region& land, const SteeredPath& path) {
  const EdgeIndex edges(land);
  double out_m = 0;
  for (const SteeredStretch& stretch : path) {
    if (stretch.length_m == 0) continue;
    const double steps = std::ceil(stretch.length_m / kCropStep_m), each_m = stretch.length_m / steps;
    for (double step = 0; step < steps; ++step)
      if (edges.contains(pose_after(stretch, (step + 0.5) * each_m).at)) out_m += each_m;
  }
  return out_m;
}

TEST(CropGroundProperties, IsWhatStepsComeTo) {
  constexpr int kObstacles = 4;
  for_each_seed(300, [&](std::mt19937_64& random, int) {
    const Field field = testing::random_field(random, kObstacles);
    Polygon land{field.outer, {}};
    for (const Obstacle& obstacle : field.obstacles) land.holes.push_back(obstacle.shape.outer);
    const CropGround crop({oriented(land)});
    const SteeredPath path = random_path(bounds(land.outer), random);
    EXPECT_NEAR(crop.length_over_m(path), looked_at_step_by_step({land}, path), 1e-9);
  });
}

}  // namespace
}  // namespace tramline
