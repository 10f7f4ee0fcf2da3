// The least cost of getting several strips past one obstacle, against areas by hand and against paths of
// random places whose swaths are sampled.

#include "tramline/cost/bound/ways_past_obstacle.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "properties/seeds.h"
#include "support/box_ring.h"

namespace tramline::ways_past_obstacle_test {

constexpr double kWidth_m = 3, kArc_m = 6, kOuter_m = kArc_m + 0.5 * kWidth_m;
constexpr double kDear = 1e6;

using testing_support::box;

/// Strips side by side from `left` on that a rectangle of corners `ring` blocks from side to side; all that
/// is known of their detours is that they go round its corners.
std::vector<StripAtObstacle> strips_at(const Ring& ring, double left, int count) {
  std::vector<StripAtObstacle> out;
  for (int i = 0; i < count; ++i) {
    StripAtObstacle strip;
    strip.left = left + i * kWidth_m;
    strip.blocked = true;
    strip.cut = kDear;
    strip.clear = {-1000, 1000};
    strip.in_the_way = {ring[0].y, ring[2].y};
    for (SideWay& way : strip.ways) way = {0, {}, ring};
    out.push_back(strip);
  }
  return out;
}

ObstacleTerms terms(const Ring& ring) {
  return {ring, kWidth_m, kArc_m, 0, 0, {ring[0].y - kOuter_m, ring[2].y + kOuter_m}, 1};
}

// The innermost detour on either side comes from its strip by an arc whose outer edge, of radius r + w/2,
// touches the strip's far line and the front of the obstacle: a square less a quarter of a disc is left, on
// both sides, before the obstacle and behind it.
TEST(WaysPastObstacle, LeaveTheCornersBetweenTheFrontAndTheInnermostDetours) {
  const Ring ring = box(-12, 0, 12, 10);
  std::vector<StripAtObstacle> strips = strips_at(ring, -12, 8);
  for (int i = 0; i < 8; ++i) strips[static_cast<std::size_t>(i)].ways[i < 4 ? 1 : 0].cost = kDear;
  const double corner_m2 = (1 - std::numbers::pi / 4) * kOuter_m * kOuter_m;
  const double least = least_cost_past(terms(ring), strips);
  EXPECT_LE(least, 4 * corner_m2);
  EXPECT_GE(least, 0.75 * 4 * corner_m2);
}

// All on the left: the detour of the last strip leaves its corner before the obstacle and behind it.
TEST(WaysPastObstacle, LeaveOneCornerBeforeAndBehindWhereAllGoRoundOnOneSide) {
  const Ring ring = box(-12, 0, 12, 10);
  std::vector<StripAtObstacle> strips = strips_at(ring, -12, 8);
  for (StripAtObstacle& strip : strips) strip.ways[1].cost = std::numeric_limits<double>::infinity();
  const double corner_m2 = (1 - std::numbers::pi / 4) * kOuter_m * kOuter_m;
  const double least = least_cost_past(terms(ring), strips);
  EXPECT_LE(least, 2 * corner_m2);
  EXPECT_GE(least, 0.75 * 2 * corner_m2);
}

// Detours that cross before the obstacle work what others leave.
TEST(WaysPastObstacle, ChargeNothingWhereDetoursMayCross) {
  const Ring ring = box(-12, 0, 12, 10);
  EXPECT_NEAR(least_cost_past(terms(ring), strips_at(ring, -12, 8)), 0, 1e-9);
}

// A track that is cut works all of its strip before the front.
TEST(WaysPastObstacle, LeaveNothingWhereAllAreCutAtAFlatFront) {
  const Ring ring = box(-12, 0, 12, 10);
  std::vector<StripAtObstacle> strips = strips_at(ring, -12, 8);
  for (StripAtObstacle& strip : strips) {
    strip.cut = 2;
    for (SideWay& way : strip.ways) way.cost = kDear;
  }
  EXPECT_NEAR(least_cost_past(terms(ring), strips), 16, 1e-9);
}

// A strip that is not blocked in every grid costs nothing, and only one that goes round pays for it.
TEST(WaysPastObstacle, ChargeNothingForAStripThatMayBeFree) {
  const Ring ring = box(-12, 0, 12, 10);
  std::vector<StripAtObstacle> strips = strips_at(ring, -15, 9);
  strips[0].blocked = false;
  for (SideWay& way : strips[0].ways) way.cost = 100;
  for (std::size_t i = 1; i < 9; ++i) strips[i].ways[0].cost = kDear;
  const double corner_m2 = (1 - std::numbers::pi / 4) * kOuter_m * kOuter_m;
  EXPECT_LE(least_cost_past(terms(ring), strips), 2 * corner_m2);
  EXPECT_GE(least_cost_past(terms(ring), strips), 0.75 * 2 * corner_m2);
}

}  // namespace tramline::ways_past_obstacle_test
