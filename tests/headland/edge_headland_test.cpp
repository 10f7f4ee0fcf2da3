// Headlands along some edges of the field, where lengths and areas are known by hand.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "headland/drawn_headlands.h"
#include "tramline/geometry/polygon/boolean.h"
#include "tramline/headland/edges/chain_ground.h"

namespace tramline::testing {
namespace {

constexpr double kPassWidth_m = 6, kTurn_m = 6;

HeadlandTerms edge_terms(std::vector<int> passes) {
  HeadlandTerms out{kPassWidth_m, kTurn_m, 0, {}};
  out.edge_passes = std::move(passes);
  return out;
}

/// Edges 0 south, 1 east, 2 north, 3 west.
Field rectangle_of(double width_m, double height_m) {
  return field_of({{0, 0}, {width_m, 0}, {width_m, height_m}, {0, height_m}});
}

TEST(EdgeHeadland, PassesAlongTwoEndsOfARectangleLeaveNothing) {
  const HeadlandAndBody found = made(rectangle_of(100, 60), edge_terms({0, 2, 0, 2}));
  ASSERT_EQ(found.passes.size(), 4U);
  for (const HeadlandPass& pass : found.passes) {
    EXPECT_NEAR(length(pass.path), 60, 1e-5);
    EXPECT_TRUE(pass.around_field);
    const double x = pass.path.front().from.x, off = pass.number == 1 ? 3 : 9;
    EXPECT_NEAR(std::min(x, 100 - x), off, 1e-6);
  }
  EXPECT_NEAR(area(found.ground), 2 * 12 * 60, 1e-3);
  EXPECT_NEAR(area(found.body), 76 * 60, 1e-3);
  EXPECT_NEAR(found.worked_m2, 2 * 12 * 60, 1e-3);
  EXPECT_NEAR(found.overlap_m2, 0, 1e-3);
  EXPECT_NEAR(found.uncovered_m2, 0, 1e-3);
  EXPECT_EQ(found.edge_passes, (std::vector<int>{0, 2, 0, 2}));
}

/// Passes driven northwards on the east side: the edges on their right.
TEST(EdgeHeadland, PassesRunWithTheirEdgesOnTheirRight) {
  const HeadlandAndBody found = made(rectangle_of(100, 60), edge_terms({0, 1, 0, 0}));
  ASSERT_EQ(found.passes.size(), 1U);
  EXPECT_GT(found.passes.front().path.back().to.y, found.passes.front().path.front().from.y);
}

TEST(EdgeHeadland, EqualNumbersAreThoseAllRound) {
  const Field field = rectangle_of(100, 60);
  const HeadlandTerms all_round{kPassWidth_m, kTurn_m, 2, {}};
  const HeadlandAndBody found = headland_of(field, edge_terms({2, 2, 2, 2})),
                        expected = headland_of(field, all_round);
  EXPECT_EQ(found.passes, expected.passes);
  EXPECT_EQ(found.ground, expected.ground);
  EXPECT_EQ(found.body, expected.body);
  EXPECT_TRUE(found.edge_passes.empty());
}

/// One pass all round, and a second one along the east only, between the first one's ends: its swath begins
/// where the first one's ends, 6 m from south and north.
TEST(EdgeHeadland, AFurtherPassStopsAtTheOneDrivenBefore) {
  const HeadlandAndBody found = made(rectangle_of(100, 60), edge_terms({1, 2, 1, 1}));
  ASSERT_EQ(found.passes.size(), 2U);
  EXPECT_TRUE(is_closed(found.passes[0]));
  EXPECT_FALSE(is_closed(found.passes[1]));
  EXPECT_EQ(found.passes[1].number, 2);
  EXPECT_NEAR(length(found.passes[1].path), 48, 0.01);
  EXPECT_NEAR(area(found.ground), 2 * 6 * 100 + 6 * 48 + 12 * 48, 1e-2);
}

/// Round a corner as all passes go: an arc of the turning radius, and nothing but its corners left or
/// doubled.
TEST(EdgeHeadland, AChainOfTwoEdgesIsDrivenRoundItsCorner) {
  const HeadlandAndBody found = made(rectangle_of(100, 60), edge_terms({0, 1, 1, 0}));
  ASSERT_EQ(found.passes.size(), 1U);
  EXPECT_NEAR(length(found.passes.front().path), 57 + 97 - (2 - std::numbers::pi / 2) * kTurn_m, 1e-4);
  EXPECT_NEAR(found.uncovered_m2, (1 - std::numbers::pi / 4) * 9 * 9, 1e-2);
  EXPECT_NEAR(found.overlap_m2, (1 - std::numbers::pi / 4) * 3 * 3, 1e-2);
  EXPECT_NEAR(area(found.ground), 6 * 100 + 6 * 54, 1e-3);
}

/// A slanted west side, 45°: behind its chain's end at the south the first pass ends at the corner, the
/// second one runs on until its outer side meets the slanted side, 6 m farther.
TEST(EdgeHeadland, GoesStraightOnToASlantedBoundary) {
  const Field field = field_of({{0, 0}, {100, 0}, {100, 60}, {-60, 60}});
  const HeadlandAndBody found = made(field, edge_terms({2, 0, 0, 0}));
  ASSERT_EQ(found.passes.size(), 2U);
  EXPECT_NEAR(length(found.passes[0].path), 100, 1e-4);
  EXPECT_NEAR(length(found.passes[1].path), 106, 1e-4);
  EXPECT_NEAR(area(found.ground), 12 * 100 + 0.5 * 12 * 12, 1e-3);
  EXPECT_NEAR(found.uncovered_m2, 2 * 0.5 * 6 * 6, 1e-2);
}

/// Under the wing of an L: beyond the chain's end the field widens, and tracks go on there.
TEST(EdgeHeadland, EndsFlatWhereTheFieldWidens) {
  const Field field = field_of({{0, 0}, {100, 0}, {100, -80}, {200, -80}, {200, 60}, {0, 60}});
  const HeadlandAndBody found = made(field, edge_terms({3, 0, 0, 0, 0, 0}));
  ASSERT_EQ(found.passes.size(), 3U);
  for (const HeadlandPass& pass : found.passes) EXPECT_NEAR(length(pass.path), 100, 1e-4);
  EXPECT_NEAR(area(found.ground), 18 * 100, 1e-3);
  EXPECT_NEAR(found.uncovered_m2 + found.overlap_m2, 0, 1e-2);
}

/// A corner that stands out into the land: an arc about it.
TEST(EdgeHeadland, AChainRoundACornerThatStandsOut) {
  const Field field = field_of({{0, 0}, {100, 0}, {100, -80}, {200, -80}, {200, 60}, {0, 60}});
  HeadlandTerms terms = edge_terms({1, 1, 0, 0, 0, 0});
  terms.radius_m = 3;  // that of the arc about the corner
  const HeadlandAndBody found = made(field, terms);
  ASSERT_EQ(found.passes.size(), 1U);
  EXPECT_NEAR(length(found.passes.front().path), 100 + 80 + 3 * std::numbers::pi / 2, 1e-3);
  EXPECT_NEAR(area(found.ground), 6 * 180 + std::numbers::pi / 4 * 36, 0.02);
}

/// Three passes along the east, two along the north, which meet at a right angle: the third one runs on to
/// the second one of the other side.
TEST(EdgeHeadland, NumbersThatChangeAtACorner) {
  const HeadlandAndBody found = made(rectangle_of(100, 60), edge_terms({0, 3, 2, 0}));
  ASSERT_EQ(found.passes.size(), 3U);
  EXPECT_EQ(found.passes[2].number, 3);
  EXPECT_NEAR(length(found.passes[2].path), 48, 0.01);
}

/// An edge digitised with many vertices is one side.
TEST(EdgeHeadland, ManyVerticesOnOneSide) {
  Ring outer{{0, 0}, {100, 0}};
  std::vector<int> passes{0};
  for (int i = 1; i <= 60; ++i) {
    outer.push_back({100 + 0.02 * (i % 3), static_cast<double>(i)});
    passes.push_back(2);
  }
  outer.back().x = 100;
  outer.push_back({0, 60});
  passes.push_back(0);
  passes.push_back(0);
  const HeadlandAndBody found = made(field_of(outer), edge_terms(passes));
  ASSERT_EQ(found.passes.size(), 2U);
  for (const HeadlandPass& pass : found.passes) EXPECT_NEAR(length(pass.path), 60, 1);
}

/// An arm 9 m wide between two facing edges: each of them has its pass, and no second one fits.
TEST(EdgeHeadland, FacingEdgesInANarrowArm) {
  const HeadlandAndBody found = made(rectangle_of(100, 9), edge_terms({2, 0, 2, 0}));
  ASSERT_EQ(found.passes.size(), 2U);
  EXPECT_NEAR(found.overlap_m2, 3 * 100, 1);
  EXPECT_NEAR(found.uncovered_m2, 0, 0.1);
  EXPECT_TRUE(found.body.empty());
}

/// An obstacle without headland on the first pass's way: the pass goes round it.
TEST(EdgeHeadland, AnObstacleNearTheEdgeIsPassed) {
  Field field = rectangle_of(200, 200);
  field.obstacles.push_back(
      {{{{196, 90}, {198, 90}, {198, 92}, {196, 92}}, {}}, ObstacleKind::kObstacle, ""});
  const HeadlandAndBody found = made(field, edge_terms({0, 2, 0, 0}));
  ASSERT_GE(found.passes.size(), 2U);
  double longest_m = 0;
  for (const HeadlandPass& pass : found.passes) longest_m = std::max(longest_m, length(pass.path));
  EXPECT_GT(longest_m, 199);
}

TEST(EdgeHeadland, AllButOneShortEdge) {
  const Field field = field_of({{0, 0}, {45, 0}, {55, 0}, {100, 0}, {100, 100}, {0, 100}});
  const HeadlandAndBody found = made(field, edge_terms({2, 0, 2, 2, 2, 2}));
  ASSERT_EQ(found.passes.size(), 2U);
  EXPECT_NEAR(area(found.ground), 100 * 100 - 76 * 76 - 10 * 12, 1e-3);
}

TEST(EdgeHeadland, OneEdgeOfATriangle) {
  const Field field = field_of({{0, 0}, {120, 0}, {60, 100}});
  const HeadlandAndBody found = made(field, edge_terms({3, 0, 0}));
  ASSERT_EQ(found.passes.size(), 3U);
  // Each ends where its inner side meets the others, 0.6 m nearer for each metre of depth.
  for (const HeadlandPass& pass : found.passes)
    EXPECT_NEAR(length(pass.path), 120 - 2 * 0.6 * 6 * pass.number, 1e-3);
}

TEST(EdgeHeadland, StripsDoNotReachOverTheBoundaryIntoAnotherArm) {
  // Two arms, 5 m apart; the chain is the western arm's eastern side.
  const Field field = field_of({{0, 0}, {60, 0}, {60, 80}, {40, 80}, {40, 20}, {35, 20}, {35, 80}, {0, 80}});
  EdgeChain chain{{40, 80}, {40, 20}};
  // Its land is on its left, to the east.
  const ChainGround ground = ground_along(chain, field.outer, 12);
  for (const Polygon& part : ground.land) EXPECT_GE(bounds(part).min_x, 40 - 1e-6);
}

}  // namespace
}  // namespace tramline::testing
