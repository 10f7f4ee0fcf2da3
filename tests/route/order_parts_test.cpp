// The steps of the driving order, one by one, by hand.

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <random>
#include <vector>

#include "properties/seeds.h"
#include "support/box_ring.h"
#include "tramline/route/order/blocks.h"
#include "tramline/route/order/hop_ground.h"
#include "tramline/route/order/point_grid.h"

namespace tramline::order {
namespace {

using testing_support::box;

/// 100 m square with a pond of 10 m square in its middle.
Field with_pond(ObstacleKind kind = ObstacleKind::kObstacle) {
  Field out;
  out.outer = box(0, 0, 100, 100);
  out.obstacles.push_back({{box(45, 45, 55, 55), {}}, kind, "pond"});
  return out;
}

// From 15 m before the pond to 25 m behind it, 2 m below its upper edge: 10 m through it, or 2 + 10 + 2 m
// along its edge.
TEST(HopGround, LeadsRoundAnObstacleByTheShorterWay) {
  const HopGround ground(with_pond(), 12);
  const Hop hop = ground.hop({30, 53}, {80, 53});
  EXPECT_NEAR(hop.length_m, 50, 1e-9);
  EXPECT_NEAR(hop.way_round_m, 54, 1e-9);
  EXPECT_TRUE(hop.barred);
  const Hop back = ground.hop({80, 53}, {30, 53});
  EXPECT_NEAR(back.way_round_m, 54, 1e-9);
}

TEST(HopGround, LeadsStraightOverWhatIsFree) {
  const HopGround ground(with_pond(), 12);
  const Hop hop = ground.hop({30, 57}, {80, 57});
  EXPECT_NEAR(hop.way_round_m, 50, 1e-9);
  EXPECT_FALSE(hop.barred);
  const HopGround passable(with_pond(ObstacleKind::kPassable), 12);
  EXPECT_FALSE(passable.hop({30, 53}, {80, 53}).barred);
}

// Pieces end at the edge of an obstacle: from edge to edge through it is through it, along its side is not.
TEST(HopGround, KnowsOnWhichSideOfAnEdgeAHopLies) {
  const HopGround ground(with_pond(), 12);
  const Hop through = ground.hop({45, 50}, {55, 50});
  EXPECT_TRUE(through.barred);
  EXPECT_NEAR(through.way_round_m, 20, 1e-9);
  EXPECT_FALSE(ground.hop({45, 46}, {45, 54}).barred);
  EXPECT_NEAR(ground.hop({45, 46}, {45, 54}).way_round_m, 8, 1e-9);
}

// A slot of 20 m reaches 60 m into the field from the north. Across it 10 m below its mouth: out over 20 m,
// or 50 m down, 20 m across and 50 m up.
Field with_slot() {
  Field out;
  out.outer = {{0, 0}, {100, 0}, {100, 100}, {60, 100}, {60, 40}, {40, 40}, {40, 100}, {0, 100}};
  return out;
}

TEST(HopGround, LeadsRoundABayOfTheField) {
  const HopGround ground(with_slot(), 12);
  const Hop hop = ground.hop({30, 90}, {70, 90});
  EXPECT_NEAR(hop.way_round_m, 10 + 120 + 10, 1e-9);
  EXPECT_TRUE(hop.barred);
}

// Swaths may run on over the edge: an end 3 m north of the field reaches it where it is nearest. From leg to
// leg that is 60 m down, across and up; within one leg the hop goes along the edge.
TEST(HopGround, KnowsPlacesOutsideTheFieldByTheNearestEdge) {
  const HopGround ground(with_slot(), 12);
  EXPECT_TRUE(ground.hop({30, 103}, {70, 103}).barred);
  EXPECT_NEAR(ground.hop({30, 103}, {70, 103}).way_round_m, 10 + 60 + 20 + 60 + 10, 1e-9);
  EXPECT_FALSE(ground.hop({10, 103}, {16, 103}).barred);
  EXPECT_NEAR(ground.hop({10, 103}, {16, 103}).way_round_m, 6, 1e-9);
}

// A pass over a corner of 1 m outside the field is no way far outside.
TEST(HopGround, ASmallBayIsNotFar) {
  Field field;
  field.outer = {{0, 0}, {100, 0}, {100, 50}, {51, 50}, {50, 49}, {49, 50}, {0, 50}};
  const Hop hop = HopGround(field, 12).hop({40, 49.5}, {60, 49.5});
  EXPECT_FALSE(hop.barred);
  EXPECT_NEAR(hop.way_round_m, 20 + (std::sqrt(2.0) - 1), 1e-9);
}

WorkedLine piece(int track, double from_x, double to_x) {
  TrackPiece out;
  out.start = {from_x, 6.0 * track};
  out.end = {to_x, 6.0 * track};
  out.track = track;
  return {out};
}

// Tracks 0 and 1 go all the way, 2 and 3 are cut at a pond, 4 goes all the way again: below, left, right,
// above.
TEST(Blocks, EndWhereAnObstacleBeginsAndEnds) {
  const std::vector<WorkedLine> lines{piece(0, 0, 100), piece(1, 0, 100),  piece(2, 0, 40), piece(2, 60, 100),
                                      piece(3, 0, 40),  piece(3, 60, 100), piece(4, 0, 100)};
  const std::vector<Block> blocks = blocks_of(lines, 6);
  EXPECT_EQ(blocks, (std::vector<Block>{{0, 1}, {2, 4}, {3, 5}, {6}}));
}

// Tracks that lie beside one another only by the width, not along, are no neighbours; nor are those of
// different subfields.
TEST(Blocks, AreOfLinesThatFaceOneAnother) {
  std::vector<WorkedLine> lines{piece(0, 0, 40), piece(1, 60, 100)};
  EXPECT_EQ(blocks_of(lines, 6).size(), 2U);
  lines[1].front().start.x = 39;
  EXPECT_EQ(blocks_of(lines, 6).size(), 1U);
  lines[1].front().subfield = 1;
  EXPECT_EQ(blocks_of(lines, 6).size(), 2U);
}

// Circular arcs 6 m apart, whose ends lie beside one another although chords would not say so.
TEST(Blocks, FollowCurves) {
  std::vector<WorkedLine> lines;
  for (int track = 0; track < 3; ++track) {
    TrackPiece arc;
    arc.track = track;
    const double radius = 50 + 6 * track;
    arc.start = {radius, 0};
    arc.end = {0, radius};
    arc.curve = {{arc.start, arc.end, 1 / radius}};
    lines.push_back({arc});
  }
  EXPECT_EQ(blocks_of(lines, 6), (std::vector<Block>{{0, 1, 2}}));
}

TEST(PointGrid, FindsTheNearestOfThoseThatAreLeft) {
  testing::for_each_seed(50, [](std::mt19937_64& random, int number) {
    std::uniform_real_distribution<double> place(0, number % 2 == 0 ? 1000 : 10);
    std::vector<Point> places;
    for (int i = 0; i < 5 + 3 * number; ++i)
      places.push_back({place(random), place(random) / (1 + number % 7)});
    PointGrid grid(places);
    std::vector<std::size_t> left(places.size());
    for (std::size_t i = 0; i < left.size(); ++i) left[i] = i;
    for (const Point asked : std::vector<Point>(places)) {
      std::stable_sort(left.begin(), left.end(), [&](std::size_t a, std::size_t b) {
        return distance(places[a], asked) < distance(places[b], asked);
      });
      const std::size_t most = std::min<std::size_t>(4, left.size());
      const std::vector<std::size_t> found = grid.nearest(asked, 4);
      ASSERT_EQ(found.size(), most);
      for (std::size_t i = 0; i < most; ++i)
        EXPECT_EQ(distance(places[found[i]], asked), distance(places[left[i]], asked));
      const Point aside = asked + Point{place(random) - place(random), place(random) - place(random)};
      double least_m = std::numeric_limits<double>::infinity();
      for (const std::size_t i : left) least_m = std::min(least_m, distance(places[i], aside));
      EXPECT_TRUE(grid.has_within(aside, 1.001 * least_m));
      EXPECT_FALSE(grid.has_within(aside, 0.999 * least_m));
      grid.remove(left.back());
      left.pop_back();
    }
  });
}

}  // namespace
}  // namespace tramline::order
