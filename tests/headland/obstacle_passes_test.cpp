// Headlands of fields with obstacles, with lengths and areas known by hand.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "headland/drawn_headlands.h"

namespace tramline::testing::obstacle_passes_test {

// About the corners of a square the pass, its outer edge and the clearance end in quarters of circles; with
// mitres all three are squares.
TEST(Headland, KeepsTheClearanceFromAnObstacle) {
  const double w = 4, clear = 1.5, side = 20;
  HeadlandTerms terms{w, 0, 0, {1}};
  terms.clearance_m = clear;
  const Field field = field_of(box(0, 0, 100, 60), {box(40, 20, 60, 40)});
  const auto grown_by = [&](double by) { return 4 * side * by + kPi * by * by; };
  const HeadlandAndBody round = made(field, terms);
  ASSERT_EQ(round.passes.size(), 1u);
  EXPECT_NEAR(length(round.passes[0].path), 4 * side + 2 * kPi * (clear + 0.5 * w), kLength);
  EXPECT_NEAR(area(round.ground), grown_by(clear + w), kChords);
  EXPECT_NEAR(round.uncovered_m2, grown_by(clear), kArea);
  EXPECT_NEAR(round.worked_m2, grown_by(clear + w) - grown_by(clear), kArea);

  terms.construction = HeadlandConstruction::kPlain;
  const auto square = [&](double by) { return (side + 2 * by) * (side + 2 * by); };
  const HeadlandAndBody plain = headland_of(field, terms);
  ASSERT_EQ(plain.passes.size(), 1u);
  EXPECT_NEAR(length(plain.passes[0].path), 4 * (side + 2 * clear + w), kLength);
  EXPECT_NEAR(area(plain.ground), square(clear + w) - square(0), kArea);
  EXPECT_NEAR(plain.uncovered_m2, square(clear) - square(0), kArea);
}

// A pass round the field keeps it too where an obstacle without passes is in its way; so does the land within
// a ring of trees.
TEST(Headland, KeepsTheClearanceFromBareObstaclesAndWithinThem) {
  HeadlandTerms terms{4, 0, 1, {0}};
  terms.clearance_m = 1;
  const HeadlandAndBody past = made(field_of(box(0, 0, 100, 60), {box(40, 2, 60, 12)}), terms);
  ASSERT_EQ(past.passes.size(), 1u);
  EXPECT_NEAR(distance_to_path({50, 12}, past.passes[0].path), 1 + 0.5 * 4, kLength);

  Field field = field_of(box(0, 0, 100, 60), {box(30, 10, 70, 50)});
  field.obstacles[0].shape.holes = {reversed(box(35, 15, 65, 45))};
  terms.obstacle_passes = {1};
  const HeadlandAndBody headland = made(field, terms);
  const auto within = std::ranges::find_if(headland.body, [](const Polygon& part) {
    return contains(part, Point{50, 30});
  });
  ASSERT_NE(within, headland.body.end());
  EXPECT_NEAR(area(*within), 28.0 * 28.0, kArea);
}

TEST(Headland, GoesRoundASquare) {
  const HeadlandAndBody headland = made(field_of(box(0, 0, 100, 100), {box(45, 45, 55, 55)}), {6, 0, 1, {1}});
  ASSERT_EQ(headland.passes.size(), 2u);
  const HeadlandPass& round = headland.passes[headland.passes[0].around_field ? 1 : 0];
  EXPECT_FALSE(round.around_field);
  EXPECT_EQ(round.obstacles, std::vector<std::size_t>{0});
  EXPECT_NEAR(length(round.path), 40 + 6 * kPi, kLength);
  EXPECT_LT(signed_area(chords(round.path)), 0) << "the body is on the left";
  EXPECT_NEAR(area(headland.ground), 100 * 100 - 88 * 88 + 240 + 36 * kPi, kChords);
  EXPECT_NEAR(headland.uncovered_m2, (4 - kPi) * 36, kChords);
  ASSERT_EQ(headland.body.size(), 1u);
  EXPECT_EQ(headland.body.front().holes.size(), 1u);
}

// A pole: the smallest circle the machine can drive, about its centre.
TEST(Headland, CirclesAPole) {
  const HeadlandAndBody headland =
      made(field_of(box(0, 0, 100, 100), {box(49.5, 49.5, 50.5, 50.5)}), {4, 6, 0, {1}});
  ASSERT_EQ(headland.passes.size(), 1u);
  EXPECT_NEAR(length(headland.passes.front().path), 12 * kPi, kLength);
  EXPECT_NEAR(distance_to_path({50, 50}, headland.passes.front().path), 6, 1e-6);
  EXPECT_NEAR(area(headland.ground), 4 * 4 + 16 * kPi, kChords);
}

// A wall 10 cm thick: both corners of an end share a circle that touches 2 m beyond it.
TEST(Headland, SwingsRoundTheEndOfAWall) {
  const HeadlandAndBody headland =
      made(field_of(box(0, 0, 100, 100), {box(40, 50, 60, 50.1)}), {4, 6, 0, {1}});
  ASSERT_EQ(headland.passes.size(), 1u);
  const Box reach = reach_of(headland.passes.front().path, 0);
  EXPECT_NEAR(reach.min_y, 50.05 - 6, 0.02);
  EXPECT_NEAR(distance_to_path({40, 50.05}, headland.passes.front().path), 2, 2e-3);
}

/// How far a path gets from y = 50 m beside the middle of a wall there, 15 m to both sides.
double farthest_beside(const Path& path) {
  double out_m = 0;
  for (const Point p : chords(path))
    if (std::abs(p.x - 50) < 15) out_m = std::max(out_m, std::abs(p.y - 50));
  return out_m;
}

// 60 m long and 10 cm thick, with a bend of 0.1 m in its middle: the circle that touches 2 m before the bend
// has its centre 4 m behind it, and reaches 10 m beyond it, where the pass on the other side goes straight
// on.
TEST(Headland, GoesStraightOnBehindABendOfAWall) {
  for (const double bend_m : {-0.1, 0.1}) {
    const Ring wall{{20, 50}, {50, 50 + bend_m}, {80, 50}, {80, 50.1}, {50, 50.1 + bend_m}, {20, 50.1}};
    const HeadlandAndBody headland = made(field_of(box(0, 0, 100, 100), {wall}), {4, 6, 0, {1}});
    ASSERT_EQ(headland.passes.size(), 1u);
    EXPECT_NEAR(farthest_beside(headland.passes.front().path), bend_m > 0 ? 2.2 : 2.1, 1e-3);
  }
}

TEST(Headland, GoesRoundAPond) {
  const HeadlandAndBody headland =
      made(field_of(box(0, 0, 100, 100), {polygon(48, 10, {50, 50})}), {6, 6, 1, {2}});
  ASSERT_EQ(headland.passes.size(), 3u);
  // Not the exact circles of 13 and 19 m: the first is wider at each corner by at most (6 − 3)·(1 −
  // cos 3.75°).
  EXPECT_NEAR(length(headland.passes[2].path), 2 * kPi * 19, 0.2);
  const HeadlandPass& first = headland.passes[headland.passes[0].around_field ? 1 : 0];
  EXPECT_NEAR(length(first.path), 2 * kPi * 13, 0.2);
}

// 4 m between obstacle and edge: one headland.
TEST(Headland, ReachesRoundAnObstacleNearTheEdge) {
  const HeadlandAndBody headland = made(field_of(box(0, 0, 100, 100), {box(45, 4, 55, 14)}), {6, 0, 1, {1}});
  ASSERT_EQ(headland.passes.size(), 1u);
  EXPECT_TRUE(headland.passes.front().around_field);
  EXPECT_EQ(headland.passes.front().obstacles, std::vector<std::size_t>{0});
  EXPECT_NEAR(area(headland.body), 88 * 88 - 22 * 8 - 60 - 18 * kPi, kChords);
  EXPECT_GT(headland.uncovered_m2, 40 + (4 - kPi) * 36) << "the land between is left";
}

// An obstacle without headland in the strip is gone round all the same; in the body it is left to the tracks.
TEST(Headland, KeepsOffObstaclesWithoutHeadland) {
  const HeadlandAndBody headland =
      made(field_of(box(0, 0, 100, 100), {box(45, 1, 55, 9), box(45, 45, 55, 55)}), {6, 6, 1, {}});
  ASSERT_EQ(headland.passes.size(), 1u);
  EXPECT_EQ(headland.passes.front().obstacles, std::vector<std::size_t>{0});
  EXPECT_NEAR(area(headland.body), 88 * 88 - 30 - 100, kChords);
}

// 18 m of room suffice for the field's two swaths and the obstacle's one; 12 m for those and an obstacle
// without.
TEST(Headland, PassesObstaclesStraight) {
  const Field field = field_of(box(0, 0, 100, 100), {box(45, 18, 55, 28), box(45, 72, 55, 88)});
  const HeadlandAndBody headland = made(field, {6, 8, 2, {1, 0}});
  ASSERT_EQ(headland.passes.size(), 3u);
  const auto once_round = [](double d) { return 4 * (100 - 2 * d) - 8 * 8 + 16 * kPi; };
  EXPECT_NEAR(length(headland.passes[0].path), once_round(3), kLength);
  EXPECT_EQ(headland.passes[1].obstacles, std::vector<std::size_t>{0});
  EXPECT_NEAR(length(headland.passes[2].path), once_round(9), kLength);
  EXPECT_TRUE(headland.passes[2].obstacles.empty());
}

// All around the obstacle a gap where the machine cannot turn. One ring or two: a second works 4 m of 10 and
// 2 m again, which is worth it, but 0.9 m of 6.9 and 5.1 m again.
TEST(Headland, GoesRoundAMoat) {
  const HeadlandAndBody wide = made(field_of(box(0, 0, 100, 100), {box(10, 10, 90, 90)}), {6, 6, 1, {1}});
  ASSERT_EQ(wide.passes.size(), 2u);
  EXPECT_EQ(wide.passes[0].around_field + wide.passes[1].around_field, 1);
  EXPECT_GT(wide.overlap_m2, 4 * 80 * 2);
  const HeadlandAndBody narrow =
      made(field_of(box(0, 0, 100, 100), {box(6.9, 6.9, 93.1, 93.1)}), {6, 6, 1, {1}});
  ASSERT_EQ(narrow.passes.size(), 1u);
  EXPECT_TRUE(narrow.passes.front().around_field);
}

// Two squares 4 m apart: the circles of 6 m about the corners that face one another meet half-way.
TEST(Headland, GoesRoundTwoObstaclesAtOnce) {
  const HeadlandAndBody headland =
      made(field_of(box(0, 0, 100, 100), {box(38, 45, 48, 55), box(52, 45, 62, 55)}), {6, 0, 0, {1, 1}});
  ASSERT_EQ(headland.passes.size(), 1u);
  EXPECT_EQ(headland.passes.front().obstacles, (std::vector<std::size_t>{0, 1}));
  EXPECT_NEAR(length(headland.passes.front().path), 60 + 6 * kPi + 24 * std::asin(2.0 / 6), kLength);
}

// An obstacle 3 m from the edge of a field without headland: nothing fits between the two. The pass is open,
// along the other three sides, and ends at the edge. Sides of 12 m, one of 15 m, and quarters of a circle
// that swing wide where the machine turns with 6 m.
TEST(Headland, PassesAnObstacleNearTheEdgeOnItsFreeSide) {
  const Field field = field_of(box(0, 0, 440, 320), {box(200, 3, 215, 15)});
  const HeadlandAndBody headland = made(field, {6, 3, 0, {1}});
  ASSERT_EQ(headland.passes.size(), 1u);
  const HeadlandPass& pass = headland.passes.front();
  EXPECT_FALSE(is_closed(pass));
  EXPECT_FALSE(pass.around_field);
  EXPECT_EQ(pass.obstacles, std::vector<std::size_t>{0});
  EXPECT_NEAR(length(pass.path), 2 * 15 + 15 + 3 * kPi, 0.01);
  EXPECT_NEAR(pass.path.front().from.y, 0, 1e-3);
  EXPECT_NEAR(pass.path.back().to.y, 0, 1e-3);
  // The ground ends on circles of 6 m about the two corners at the edge, the swath goes straight on for 3 m.
  EXPECT_NEAR(headland.overlap_m2, 2 * (6 * 3 - 0.5 * (3 * std::sqrt(27.0) + 36 * kPi / 6)), kChords);
  // All but the 3 m between obstacle and edge.
  EXPECT_NEAR(headland.uncovered_m2, 15 * 3, 0.1);
  const Field in_corner = field_of(box(0, 0, 440, 320), {box(3, 3, 18, 15)});
  const HeadlandAndBody corner = made(in_corner, {6, 3, 0, {1}});
  ASSERT_EQ(corner.passes.size(), 1u);
  EXPECT_NEAR(length(corner.passes.front().path), 18 + 15 + 1.5 * kPi, 0.01);
}

// There is room for a swath between obstacle and edge, 8 m: it is driven round.
TEST(Headland, DrivesRoundAnObstacleWithRoomBehindIt) {
  const HeadlandAndBody headland =
      made(field_of(box(0, 0, 440, 320), {box(200, 8, 215, 20)}), {6, 3, 0, {1}});
  ASSERT_EQ(headland.passes.size(), 1u);
  EXPECT_TRUE(is_closed(headland.passes.front()));
}

// A wall of 300 m along the edge has no headland: the ring round the field would follow it for as long, on
// ground that the body has. It ends at the wall instead.
TEST(Headland, EndsAtALongObstacleWithoutHeadland) {
  const HeadlandAndBody headland = made(field_of(box(0, 0, 440, 320), {box(70, 2, 370, 8)}), {6, 6, 1, {}});
  ASSERT_EQ(headland.passes.size(), 1u);
  EXPECT_FALSE(is_closed(headland.passes.front()));
  EXPECT_LT(length(headland.passes.front().path), 2 * (440 + 320) - 300);
  EXPECT_LT(headland.overlap_m2, 300);
}

// A block of 32 m by 39 m close to the edge has a recess 12 m wide and 7 m deep on the edge's side, and a
// post stands in the recess. The pass ends at the block on either side; none goes into the recess, over the
// post.
TEST(Headland, KeepsOutOfARecessWithAPostInIt) {
  const Ring block{{60, 1}, {70, 1}, {70, 7}, {82, 7}, {82, 1}, {92, 1}, {92, 40}, {60, 40}};
  const HeadlandAndBody headland =
      made(field_of(box(0, 0, 200, 120), {block, box(75, 1.5, 77, 3)}), {6, 6, 1, {}});
  ASSERT_EQ(headland.passes.size(), 1u);
  EXPECT_FALSE(is_closed(headland.passes.front()));
}

TEST(Headland, IsNotWorkedOnPassableLand) {
  Field field = field_of(box(0, 0, 100, 60), {box(48, 0, 52, 60)});
  field.obstacles.front().kind = ObstacleKind::kPassable;
  const HeadlandAndBody headland = made(field, {6, 0, 1, {1}});
  ASSERT_EQ(headland.passes.size(), 1u);
  EXPECT_TRUE(headland.passes.front().obstacles.empty());
  EXPECT_NEAR(headland.worked_m2, 6 * length(headland.passes.front().path) - 2 * 4 * 6, kArea);
  EXPECT_NEAR(area(headland.body), 88 * 48 - 4 * 48, kArea);
  EXPECT_NEAR(headland.uncovered_m2, (4 - kPi) * 36, kArea);
}

TEST(Headland, LeavesLandInsideAnObstacleAlone) {
  Field field = field_of(box(0, 0, 100, 100), {box(40, 40, 60, 60)});
  field.obstacles.front().shape.holes.push_back(reversed(box(45, 45, 55, 55)));
  const HeadlandAndBody headland = made(field, {6, 0, 1, {1}});
  EXPECT_EQ(headland.passes.size(), 2u);
  EXPECT_EQ(headland.body.size(), 2u);
  EXPECT_NEAR(area(headland.body), 88 * 88 - 400 - 480 - 36 * kPi + 100, kChords);
}

}  // namespace tramline::testing::obstacle_passes_test
