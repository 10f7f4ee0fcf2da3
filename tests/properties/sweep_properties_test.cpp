// The quick ways of the sweep give what plain scans give, to the last bit.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "properties/random_field.h"
#include "properties/seeds.h"
#include "tramline/decomposition/candidate_directions.h"
#include "tramline/decomposition/cuts.h"
#include "tramline/decomposition/merge_equal_directions.h"
#include "tramline/decomposition/merge_similar_directions.h"
#include "tramline/decomposition/merge_small_cells.h"
#include "tramline/decomposition/tolerances.h"
#include "tramline/decomposition/turned_boundary.h"
#include "tramline/headland/body.h"

namespace tramline {
namespace {

std::vector<Ring> rings_in_order(const Polygon& polygon) {
  std::vector<Ring> rings{polygon.outer};
  rings.insert(rings.end(), polygon.holes.begin(), polygon.holes.end());
  return rings;
}

/// All edges, one after another.
Hit nearest_by_scan(const std::vector<Ring>& turned, Point start, int sense) {
  Hit hit;
  const auto offer = [&](double y, std::size_t ring, std::size_t index, bool vertex) {
    const double reach = sense * (y - start.y);
    if (reach > kSameLine && reach < hit.reach) hit = {reach, ring, index, vertex};
  };
  for (std::size_t r = 0; r < turned.size(); ++r)
    for (std::size_t i = 0; i < turned[r].size(); ++i) {
      const Point a = turned[r][i], b = turned[r][(i + 1) % turned[r].size()];
      const double to_a = a.x - start.x, to_b = b.x - start.x;
      if (std::abs(to_a) <= kSameLine)
        offer(a.y, r, i, true);
      else if (std::abs(to_b) > kSameLine && (to_a < 0) != (to_b < 0))
        offer(a.y + (b.y - a.y) * (to_a / (to_a - to_b)), r, i, false);
    }
  return hit;
}

bool inside_by_scan(const std::vector<Ring>& turned, Point p) {
  bool odd = false;
  for (const Ring& ring : turned) odd = odd != contains(ring, p);
  return odd;
}

std::size_t corners_by_scan(const std::vector<Ring>& rings, Point vertex) {
  std::size_t count = 0;
  for (const Ring& ring : rings)
    count += static_cast<std::size_t>(std::count(ring.begin(), ring.end(), vertex));
  return count;
}

void compare_questions(const Polygon& polygon, Direction sweep, std::mt19937_64& random) {
  const TrackFrame frame(sweep);
  const TurnedBoundary boundary(polygon, frame);
  const std::vector<Ring> rings = rings_in_order(polygon);
  std::vector<Ring> turned;
  for (const Ring& ring : rings) turned.push_back(frame.to_track(ring));
  std::uniform_real_distribution<double> anywhere(-220, 220);
  for (const Ring& ring : rings)
    for (const Point vertex : ring) {
      EXPECT_EQ(boundary.corners_at(vertex).size(), corners_by_scan(rings, vertex));
      const Point start = frame.to_track(vertex);
      for (const Point from : {start, Point{anywhere(random), anywhere(random)}, Point{start.x + 5e-7, 0}}) {
        for (const int sense : {+1, -1})
          EXPECT_EQ(boundary.nearest(from, sense), nearest_by_scan(turned, from, sense));
        EXPECT_EQ(boundary.inside(from), inside_by_scan(turned, from));
      }
    }
}

TEST(SweepProperties, RaysMeetWhatAScanOfAllEdgesFinds) {
  testing::for_each_seed(60, [](std::mt19937_64& random, int) {
    const Field field = testing::random_field(random, 6);
    for (const Polygon& ground : body_of(field))
      for (const Direction sweep : candidate_directions(field)) compare_questions(ground, sweep, random);
  });
}

// A hole that touches the outer ring, and edges along the ray.
TEST(SweepProperties, RaysMeetWhatAScanFindsWhereRingsTouch) {
  std::mt19937_64 random(1);
  const Polygon ground{{{0, 0}, {50, 0}, {100, 0}, {100, 100}, {0, 100}},
                       {{{50, 0}, {40, 30}, {50, 60}, {60, 30}}, {{20, 40}, {20, 60}, {30, 60}, {30, 40}}}};
  for (const double degrees : {0.0, 90.0, 30.0})
    compare_questions(ground, Direction::clockwise_from_north(Angle::degrees(degrees)), random);
  const TurnedBoundary boundary(ground, TrackFrame(Direction::clockwise_from_north(Angle::degrees(0))));
  EXPECT_EQ(boundary.corners_at({50, 0}).size(), 2u);
}

/// All pairs looked at before every merge.
void merge_by_scan(MergeGraph& graph, Remember remember, const MergeRule& rule) {
  while (true) {
    double longest = 0;
    std::size_t best_a = 0, best_b = 0;
    for (std::size_t a = 0; a < graph.nodes.size(); ++a)
      for (const auto& [b, length] : graph.nodes[a].shared) {
        if (b <= a || length <= longest || !rule.eligible(graph.nodes[a], graph.nodes[b])) continue;
        longest = length;
        best_a = a;
        best_b = b;
      }
    if (longest <= 0) return;
    merge(graph, best_a, best_b, remember);
  }
}

bool same(const MergeNode& a, const MergeNode& b) {
  return a.alive == b.alive && a.cells == b.cells && a.area_m2 == b.area_m2 && a.direction == b.direction &&
         a.history == b.history && a.shared == b.shared;
}

/// Merges both graphs, one of them by the scan. Returns how many are left.
std::size_t compare_phase(MergeGraph& quick, MergeGraph& plain, Remember remember, const MergeRule& rule) {
  merge_longest_edge_first(quick, remember, rule);
  merge_by_scan(plain, remember, rule);
  EXPECT_TRUE(
      std::equal(quick.nodes.begin(), quick.nodes.end(), plain.nodes.begin(), plain.nodes.end(), same));
  return static_cast<std::size_t>(std::count_if(quick.nodes.begin(), quick.nodes.end(),
                                                [](const MergeNode& node) { return node.alive; }));
}

TEST(SweepProperties, CellsMergeInTheOrderInWhichAScanOfAllPairsMergesThem) {
  std::size_t before = 0, equal = 0, large = 0, similar = 0;
  testing::for_each_seed(60, [&](std::mt19937_64& random, int) {
    Field field = testing::random_field(random, 6);
    // Right angles make equal directions and equal lengths.
    if (random() % 2 == 0)
      for (Point& p : field.outer) p = {20 * std::round(p.x / 20), 20 * std::round(p.y / 20)};
    const double small_cell_m2 = std::exp(std::uniform_real_distribution<double>(3, 8)(random));
    const Angle threshold = Angle::degrees(std::uniform_real_distribution<double>(0, 90)(random));
    for (const Polygon& ground : body_of(field))
      for (const Direction sweep : candidate_directions(field)) {
        MergeGraph quick =
            merge_graph(sweep_cells({ground}, sweep, Angle::degrees(180), CellDirection::kRectangle));
        MergeGraph plain = quick;
        before += quick.nodes.size();
        equal += compare_phase(quick, plain, Remember::kBoth, equal_directions());
        large += compare_phase(quick, plain, Remember::kLargerOnly, small_cells(small_cell_m2));
        similar += compare_phase(quick, plain, Remember::kBoth, similar_directions(threshold));
      }
  });
  // Every phase has had something to do.
  EXPECT_LT(equal, before);
  EXPECT_LT(large, equal);
  EXPECT_LT(similar, large);
}

}  // namespace
}  // namespace tramline
