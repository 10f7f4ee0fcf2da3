#include "tramline/geometry/index/edge_index.h"

#include <gtest/gtest.h>

#include "geometry/random_shapes.h"

namespace tramline::edge_index_test {

using testing::RandomCase;

/// How often the rings go round p, by the angles under which it sees their edges: 1 inside, 0 outside.
int windings(const Region& region, Point p) {
  double sum = 0;
  for (const Ring& ring : rings_of(region))
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const Point a = ring[i] - p, b = ring[(i + 1) % ring.size()] - p;
      sum += std::atan2(cross(a, b), dot(a, b));
    }
  return static_cast<int>(std::lround(sum / (2 * std::numbers::pi)));
}

TEST(EdgeIndex, HoldsEveryEdgeInTheSenseOfItsRing) {
  const Ring outer{{0, 0}, {9, 0}, {9, 9}, {0, 9}}, hole{{3, 3}, {3, 6}, {6, 3}};
  const EdgeIndex index({{outer, {hole}}});
  const std::vector<std::pair<Point, Point>> expected{{{0, 0}, {9, 0}}, {{9, 0}, {9, 9}}, {{9, 9}, {0, 9}},
                                                      {{0, 9}, {0, 0}}, {{3, 3}, {3, 6}}, {{3, 6}, {6, 3}},
                                                      {{6, 3}, {3, 3}}};
  ASSERT_EQ(index.edges().size(), expected.size());
  for (std::size_t i = 0; i < expected.size(); ++i) {
    EXPECT_EQ(index.edges()[i].from, expected[i].first) << i;
    EXPECT_EQ(index.edges()[i].to, expected[i].second) << i;
  }
}

TEST(EdgeIndex, FindsTheEdgesAtAPlace) {
  const EdgeIndex index({{{{0, 0}, {9, 0}, {9, 9}, {0, 9}}, {{{3, 3}, {3, 6}, {6, 3}}}}});
  const auto near = [&](Point p) {
    std::vector<std::size_t> out;
    index.grid().each_meeting(bounds(p, p).grown(0.5), [&](std::size_t e) { out.push_back(e); });
    std::sort(out.begin(), out.end());
    return out;
  };
  EXPECT_EQ(near({9, 0}), (std::vector<std::size_t>{0, 1}));
  EXPECT_EQ(near({0, 5}), (std::vector<std::size_t>{3}));
  EXPECT_EQ(near({3, 3}), (std::vector<std::size_t>{4, 5, 6})) << "by their boxes";
  EXPECT_TRUE(near({7.5, 7.5}).empty());
}

TEST(EdgeIndex, ContainsThePointsThatItsRingsGoRound) {
  int inside = 0, outside = 0;
  for (int number = 0; number < 100; ++number) {
    RandomCase random(number);
    const Region region = testing::random_region(random);
    const EdgeIndex index(region);
    for (int i = 0; i < 100; ++i) {
      const Point p = random.point_in({-60, -60, 140, 60});
      const int times = windings(region, p);
      ASSERT_EQ(index.contains(p), times == 1) << p.x << " " << p.y;
      ++(times == 1 ? inside : outside);
    }
  }
  EXPECT_GT(inside, 1000);
  EXPECT_GT(outside, 1000);
}

// A ray through a corner must count it once, or not at all.
TEST(EdgeIndex, ContainsPointsLevelWithCorners) {
  const EdgeIndex diamond({{{{5, 0}, {10, 5}, {5, 10}, {0, 5}}, {}}});
  EXPECT_TRUE(diamond.contains({4, 5}));
  EXPECT_FALSE(diamond.contains({-1, 5}));
  EXPECT_FALSE(diamond.contains({-1, 0}));
  EXPECT_FALSE(diamond.contains({-1, 10}));
  EXPECT_FALSE(diamond.contains({11, 5}));
}

}  // namespace tramline::edge_index_test
