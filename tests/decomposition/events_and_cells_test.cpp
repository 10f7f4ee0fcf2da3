// Scenes of the kind Versleijen figs. 13 and 14 show: a field with an obstacle, split events at
// the corners whose field-side angle exceeds the threshold, cells from cuts parallel to the sweep.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "tramline/decomposition/candidate_directions.h"
#include "tramline/decomposition/cells.h"
#include "tramline/decomposition/cuts.h"
#include "tramline/decomposition/events.h"
#include "tramline/decomposition/sweep_directions.h"

namespace tramline {
namespace {

const Direction kNorth = Direction::clockwise_from_north(Angle::degrees(0));

/// A rectangle with a diamond-shaped obstacle in its middle.
const Polygon kFieldWithDiamond{{{0, 0}, {100, 0}, {100, 60}, {0, 60}},
                                {{{30, 30}, {50, 40}, {70, 30}, {50, 20}}}};

TEST(InteriorAngle, IsMeasuredOnTheFieldsSide) {
  // Corner of a counter-clockwise square: 90. The same corner walked clockwise: 270.
  EXPECT_NEAR(interior_angle({0, 0}, {1, 0}, {1, 1}).degrees(), 90, 1e-9);
  EXPECT_NEAR(interior_angle({1, 1}, {1, 0}, {0, 0}).degrees(), 270, 1e-9);
  EXPECT_NEAR(interior_angle({0, 0}, {1, 0}, {2, 0}).degrees(), 180, 1e-9);
}

TEST(SplitEvents, AreTheCornersAboveTheThreshold) {
  // Diamond corners seen from the field: left and right 360 − 2·atan(1/2) = 306.87, top and bottom
  // 360 − 126.87 = 233.13 degrees.
  EXPECT_EQ(split_events(kFieldWithDiamond, Angle::degrees(180)).size(), 4u);
  EXPECT_EQ(split_events(kFieldWithDiamond, Angle::degrees(240)).size(), 2u);
  EXPECT_EQ(split_events(kFieldWithDiamond, Angle::degrees(310)).size(), 0u);
}

// All edges of the diamond are √500 = 22.4 m long.
TEST(SplitEvents, AreNoCornersBetweenShortEdges) {
  EXPECT_EQ(split_events(kFieldWithDiamond, Angle::degrees(180), 22).size(), 4u);
  EXPECT_EQ(split_events(kFieldWithDiamond, Angle::degrees(180), 23).size(), 0u);
}

TEST(Cuts, RunFromTheVertexToTheNextBoundaryOnBothSides) {
  const auto cuts = cuts_at(kFieldWithDiamond, split_events(kFieldWithDiamond, Angle::degrees(240)), kNorth);
  ASSERT_EQ(cuts.size(), 4u);  // two corners, up and down
  for (const Cut& cut : cuts) {
    EXPECT_TRUE(cut.from == (Point{30, 30}) || cut.from == (Point{70, 30}));
    EXPECT_NEAR(std::abs(cut.to.y - 30), 30, 1e-9);
    EXPECT_NEAR(cut.to.x, cut.from.x, 1e-9);
    EXPECT_EQ(cut.ring, 0);
  }
}

TEST(Cuts, StartOnlyOnTheSideOfTheField) {
  // The top corner (50, 40) of the diamond sees the field upwards only; the hole runs clockwise.
  const auto cuts = cuts_at(kFieldWithDiamond, {{{30, 30}, {50, 40}, {70, 30}}}, kNorth);
  ASSERT_EQ(cuts.size(), 1u);
  EXPECT_NEAR(cuts[0].to.y, 60, 1e-9);
}

// Two reflex corners face each other across 20 m: one cut, from corner to corner.
TEST(Cuts, EndInAVertexTheyPassWithinAMicrometre) {
  const Polygon waist{{{0, 0}, {50, 20}, {100, 0}, {100, 60}, {50.0000005, 40}, {0, 60}}, {}};
  const auto cuts = cuts_at(waist, split_events(waist, Angle::degrees(180)), kNorth);
  ASSERT_EQ(cuts.size(), 2u);
  EXPECT_EQ(cuts[0].ring, -1);
  EXPECT_EQ(cuts[0].to, (Point{50.0000005, 40}));
  EXPECT_EQ(divided(waist, cuts).size(), 2u);
}

TEST(SweepCells, AreSixRoundADiamondAtThreshold180) {
  // Cuts at x = 30, 50 (above and below the diamond) and 70: left, right, and two above, two below.
  const auto cells = sweep_cells({kFieldWithDiamond}, kNorth, Angle::degrees(180), CellDirection::kRectangle);
  EXPECT_EQ(cells.size(), 6u);
  double sum = 0;
  for (const Cell& cell : cells) {
    sum += area(cell.shape);
    EXPECT_TRUE(split_events(cell.shape, Angle::degrees(180.001)).empty()) << "a cell is not convex";
  }
  EXPECT_NEAR(sum, 6000 - 400, 1e-6);  // diamond: ½·40·20
}

TEST(SweepCells, AreFourAtThreshold240) {
  EXPECT_EQ(sweep_cells({kFieldWithDiamond}, kNorth, Angle::degrees(240), CellDirection::kRectangle).size(),
            4u);
}

TEST(SweepCells, OfAConvexFieldAreTheField) {
  const Polygon square{{{0, 0}, {10, 0}, {10, 10}, {0, 10}}, {}};
  const auto cells = sweep_cells({square}, kNorth, Angle::degrees(180), CellDirection::kRectangle);
  ASSERT_EQ(cells.size(), 1u);
  EXPECT_EQ(cells[0].shape, square);
}

// An L: the reflex corner (10, 10) has edges along both axes, so a north cut follows the one edge and
// leaves one cut downwards: two cells.
TEST(SweepCells, OfAnLAreTwo) {
  const Polygon l_shape{{{0, 0}, {30, 0}, {30, 10}, {10, 10}, {10, 40}, {0, 40}}, {}};
  const auto cells = sweep_cells({l_shape}, kNorth, Angle::degrees(180), CellDirection::kRectangle);
  ASSERT_EQ(cells.size(), 2u);
  std::vector<double> areas{area(cells[0].shape), area(cells[1].shape)};
  std::sort(areas.begin(), areas.end());
  EXPECT_NEAR(areas[0], 200, 1e-6);
  EXPECT_NEAR(areas[1], 400, 1e-6);
  for (const Cell& cell : cells) EXPECT_NEAR(cell.direction.degrees(), area(cell.shape) < 300 ? 90 : 0, 1e-6);
}

// A hole touches the outline in (50, 0): of its two rays the one that points out of the field is none.
TEST(Cuts, StayInsideWhereAHoleTouchesTheOutline) {
  const Polygon field{{{0, 0}, {50, 0}, {100, 0}, {100, 60}, {0, 60}}, {{{50, 0}, {40, 20}, {60, 20}}}};
  const Direction oblique = Direction::clockwise_from_north(Angle::degrees(60));
  const auto cuts = cuts_at(field, split_events(field, Angle::degrees(180)), oblique);
  for (const Cut& cut : cuts) EXPECT_TRUE(contains(field, midpoint(cut.from, cut.to)));
  // One at the touching corner, to the right; two at (40, 20); one at (60, 20), whose other ray enters the
  // hole.
  EXPECT_EQ(cuts.size(), 4u);
  double sum = 0;
  for (const Polygon& cell : divided(field, cuts)) sum += area(cell);
  EXPECT_NEAR(sum, 6000 - 200, 1e-9);
}

// The sweep may differ from the edge it comes from by a microradian: the ray then leaves along the
// edge, and there is no cut.
TEST(Cuts, DoNotFollowAnEdge) {
  const Polygon l_shape{{{0, 0}, {30, 0}, {30, 10}, {10, 10}, {10, 10.4}, {0, 10.4}}, {}};
  const Direction nearly_north = Direction::clockwise_from_north(Angle::radians(3e-6));
  for (const Direction sweep : {kNorth, nearly_north}) {
    const auto cuts = cuts_at(l_shape, split_events(l_shape, Angle::degrees(180)), sweep);
    ASSERT_EQ(cuts.size(), 1u);
    EXPECT_NEAR(cuts[0].to.y, 0, 1e-9);
    EXPECT_NEAR(area(divided(l_shape, cuts)), area(l_shape), 1e-9);
  }
}

// Seven convex cells, as in Versleijen fig. 14: a quadrilateral obstacle and one reflex corner in the
// outline. Cuts at x = 20 (left corner of the obstacle, both ways), 40 (its top corner, up), 45 (its
// bottom corner, down), 60 (right corner, both ways) and at the reflex corner (80, 50), down.
TEST(SweepCells, AreSevenForAnObstacleAndANotch) {
  const Polygon field{{{0, 0}, {100, 0}, {100, 60}, {80, 50}, {60, 70}, {0, 60}},
                      {{{20, 30}, {40, 40}, {60, 32}, {45, 20}}}};
  ASSERT_EQ(split_events(field, Angle::degrees(180)).size(), 5u);
  const auto cells = sweep_cells({field}, kNorth, Angle::degrees(180), CellDirection::kRectangle);
  EXPECT_EQ(cells.size(), 7u);
  for (const Cell& cell : cells) EXPECT_TRUE(split_events(cell.shape, Angle::degrees(180.001)).empty());
}

TEST(CandidateDirections, AreDistinctModulo180AndLeavePassableObstaclesOut) {
  Field field;
  field.outer = {{0, 0}, {100, 0}, {100, 60}, {0, 60}};
  field.obstacles = {{{{{30, 30}, {50, 20}, {70, 30}, {50, 40}}, {}}, ObstacleKind::kObstacle, "hole 1"},
                     {{{{80, 30}, {83, 30}, {85, 50}}, {}}, ObstacleKind::kPassable, "waterway"}};
  const auto directions = candidate_directions(field);
  ASSERT_EQ(directions.size(), 4u);
  EXPECT_NEAR(directions[0].degrees(), 0, 1e-9);
  EXPECT_NEAR(directions[1].degrees(), 90 - 26.565051177, 1e-6);
  EXPECT_NEAR(directions[2].degrees(), 90, 1e-9);
  EXPECT_NEAR(directions[3].degrees(), 90 + 26.565051177, 1e-6);
}

/// A field of `corners` corners on an ellipse.
Field ellipse(int corners) {
  Field field;
  for (int i = 0; i < corners; ++i) {
    const double angle = 2 * std::numbers::pi * i / corners;
    field.outer.push_back({300 * std::cos(angle), 200 * std::sin(angle)});
  }
  return field;
}

// Opposite edges of an ellipse are parallel where it has an even number of corners.
TEST(SweepDirections, AreAllOfTheCandidatesUpToALimit) {
  const Field field = ellipse(2 * static_cast<int>(kMostSweepDirections));
  ASSERT_EQ(candidate_directions(field).size(), kMostSweepDirections);
  EXPECT_EQ(sweep_directions(field), candidate_directions(field));
}

TEST(SweepDirections, OfMoreKeepTheLongestEdgesAndLeaveNoWideGap) {
  Field field;
  // A long edge, so near to its neighbours that one of these would do.
  field.outer = {{0, 0}, {1000, 1}};
  for (int i = 0; i < 1001; ++i) {
    const double angle = std::numbers::pi * (i + 0.5) / 1001;
    field.outer.push_back({500 + 500 * std::cos(angle), 2 + 300 * std::sin(angle)});
  }
  const std::vector<Direction> all = candidate_directions(field), some = sweep_directions(field);
  ASSERT_GT(all.size(), kMostSweepDirections);
  ASSERT_LE(some.size(), kThinnedDirections);
  EXPECT_EQ(std::count(some.begin(), some.end(), Direction::along({0, 0}, {1000, 1})), 1);
  EXPECT_TRUE(std::is_sorted(some.begin(), some.end()));
  const double apart = 180.0 / static_cast<double>(kThinnedDirections);
  for (const Direction one : some) {
    EXPECT_TRUE(std::binary_search(all.begin(), all.end(), one));
    for (const Direction other : some)
      EXPECT_TRUE(one == other || angle_between(one, other).degrees() > apart - 1e-9);
  }
  for (const Direction left_out : all)
    EXPECT_TRUE(std::any_of(some.begin(), some.end(), [&](Direction kept) {
      return angle_between(kept, left_out).degrees() < apart + 1e-9;
    }));
}

}  // namespace
}  // namespace tramline
