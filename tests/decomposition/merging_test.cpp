#include <gtest/gtest.h>

#include "tramline/decomposition/decompose.h"
#include "tramline/decomposition/merge_equal_directions.h"
#include "tramline/decomposition/merge_similar_directions.h"
#include "tramline/decomposition/merge_small_cells.h"

namespace tramline {
namespace {

Direction at(double degrees) { return Direction::clockwise_from_north(Angle::degrees(degrees)); }

Polygon box(double x0, double y0, double x1, double y1) {
  return {{{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}}, {}};
}

/// Cells side by side, 50 m high, of the given widths and directions: each touches only the next.
MergeGraph row(std::vector<std::pair<double, double>> width_and_degrees) {
  std::vector<Cell> cells;
  double x = 0;
  for (const auto& [width, degrees] : width_and_degrees) {
    cells.push_back({box(x, 0, x + width, 50), at(degrees)});
    x += width;
  }
  return merge_graph(cells);
}

TEST(MergeGraph, MeasuresSharedEdges) {
  const MergeGraph graph = row({{10, 0}, {20, 0}, {30, 0}});
  EXPECT_NEAR(graph.nodes[0].shared.at(1), 50, 1e-12);
  EXPECT_NEAR(graph.nodes[1].shared.at(2), 50, 1e-12);
  EXPECT_EQ(graph.nodes[0].shared.count(2), 0u);
}

TEST(Phase1, JoinsNeighboursOfEqualDirectionOnly) {
  MergeGraph graph = row({{10, 30}, {10, 30}, {10, 31}, {10, 30}});
  merge_equal_directions(graph);
  const auto subfields = subfields_of(graph);
  ASSERT_EQ(subfields.size(), 3u);
  EXPECT_NEAR(area(subfields[0].shape), 1000, 1e-9);
}

TEST(Phase1, TakesDirectionsModulo180) {
  MergeGraph graph = row({{10, 0}, {10, 180}});
  merge_equal_directions(graph);
  EXPECT_EQ(subfields_of(graph).size(), 1u);
}

// 3 × 50 = 150 m² < 200 m²: joins the neighbour with the longest shared edge, whatever its direction.
TEST(Phase2, SmallCellsJoinTheNeighbourWithTheLongestEdge) {
  std::vector<Cell> cells{
      {box(0, 0, 3, 50), at(0)}, {box(3, 0, 60, 30), at(80)}, {box(3, 30, 60, 50), at(10)}};
  // The small cell's right side must be split where its two neighbours meet, as noded cells are.
  cells[0].shape.outer = {{0, 0}, {3, 0}, {3, 30}, {3, 50}, {0, 50}};
  MergeGraph graph = merge_graph(cells);
  merge_small_cells(graph, 200);
  const auto subfields = subfields_of(graph);
  ASSERT_EQ(subfields.size(), 2u);
  EXPECT_NEAR(area(subfields[0].shape), 150 + 57 * 30, 1e-9);
  EXPECT_NEAR(subfields[0].direction.degrees(), 80, 1e-9);
}

TEST(Phase2, LeavesCellsOf200SquareMetresAlone) {
  MergeGraph graph = row({{4, 0}, {40, 50}});
  merge_small_cells(graph, 200);
  EXPECT_EQ(subfields_of(graph).size(), 2u);
}

TEST(Phase3, IsInclusiveAndModulo180) {
  MergeGraph graph = row({{20, 175}, {30, 5}});
  merge_similar_directions(graph, Angle::degrees(10));
  const auto subfields = subfields_of(graph);
  ASSERT_EQ(subfields.size(), 1u);
  EXPECT_NEAR(subfields[0].direction.degrees(), 5, 1e-9) << "the larger part keeps its direction";

  MergeGraph apart = row({{20, 175}, {30, 5.001}});
  merge_similar_directions(apart, Angle::degrees(10));
  EXPECT_EQ(subfields_of(apart).size(), 2u);
}

// Versleijen §2.2.3, fig. 16: b and c are equal and merge; a (90 − 12) and d (90 + 12) are each within 12
// degrees of bc but not of one another: bc takes one of them, not both.
TEST(HistoryRule, LetsOneNeighbourInButNotBoth) {
  MergeGraph graph = row({{20, 78}, {20, 90}, {20, 90}, {30, 102}});
  merge_equal_directions(graph);
  merge_small_cells(graph, 200);
  merge_similar_directions(graph, Angle::degrees(12));
  const auto subfields = subfields_of(graph);
  ASSERT_EQ(subfields.size(), 2u);
}

TEST(HistoryRule, ForgetsNothingWhenTheLargerDirectionWins) {
  // 0 + 8 → direction 8 (larger); 16 is within 10 of 8 but not of the remembered 0.
  MergeGraph graph = row({{20, 0}, {30, 8}, {10, 16}});
  merge_similar_directions(graph, Angle::degrees(10));
  EXPECT_EQ(subfields_of(graph).size(), 2u);
}

TEST(Decompose, KeepsTheArea) {
  PlanSettings settings;
  const Polygon field{{{0, 0}, {100, 0}, {100, 60}, {0, 60}}, {{{30, 30}, {50, 40}, {70, 30}, {50, 20}}}};
  double sum = 0;
  for (const Subfield& subfield : decompose({field}, at(0), settings)) sum += area(subfield.shape);
  EXPECT_NEAR(sum, 5600, 1e-6);
}

}  // namespace
}  // namespace tramline
