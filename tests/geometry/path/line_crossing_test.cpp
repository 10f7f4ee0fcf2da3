#include "tramline/geometry/path/line_crossing.h"

#include <gtest/gtest.h>

#include "geometry/random_shapes.h"

namespace tramline::line_crossing_test {

using testing::RandomCase;
using Edges = std::pair<std::size_t, std::size_t>;

TEST(SelfCrossing, NamesTheEdgesThatCross) {
  EXPECT_EQ(self_crossing({{0, 0}, {10, 0}, {10, 10}, {5, -5}}), (Edges{0, 2}));
  EXPECT_EQ(self_crossing({{-9, 3}, {0, 0}, {10, 0}, {10, 10}, {5, -5}}), (Edges{1, 3}));
  EXPECT_EQ(self_crossing({{0, 0}, {10, 0}, {10, 10}, {0, 10}}), std::nullopt);
}

TEST(SelfCrossing, CountsLinesThatOnlyTouch) {
  EXPECT_EQ(self_crossing({{0, 0}, {10, 0}, {10, 10}, {4, 0}}), (Edges{0, 2})) << "ends on itself";
  EXPECT_EQ(self_crossing({{0, 0}, {10, 0}, {10, 10}, {0, 0}}), (Edges{0, 2})) << "ends where it began";
  EXPECT_EQ(self_crossing({{0, 0}, {9, 0}, {9, 5}, {12, 5}, {12, 0}, {5, 0}}), (Edges{0, 4}))
      << "along itself";
  EXPECT_EQ(self_crossing({{0, 0}, {9, 0}, {12, 5}, {15, 0}, {11, 0}}), std::nullopt) << "on one line, apart";
}

TEST(SelfCrossing, LeavesNeighboursOut) {
  EXPECT_EQ(self_crossing({{0, 0}, {10, 0}, {3, 0}}), std::nullopt) << "straight back";
  EXPECT_EQ(self_crossing({{0, 0}, {10, 0}}), std::nullopt);
  EXPECT_EQ(self_crossing({{0, 0}}), std::nullopt);
  EXPECT_EQ(self_crossing({}), std::nullopt);
}

/// Of corners whose coordinates are small whole numbers, without rounding.
bool meet(Point a, Point b, Point c, Point d) {
  const double turn = cross(b - a, d - c), at = cross(c - a, d - c), other = cross(c - a, b - a);
  if (turn != 0)
    return at * turn >= 0 && other * turn >= 0 && std::abs(at) <= std::abs(turn) &&
           std::abs(other) <= std::abs(turn);
  if (other != 0) return false;
  const double end = dot(b - a, b - a), from = dot(c - a, b - a), to = dot(d - a, b - a);
  return std::max(from, to) >= 0 && std::min(from, to) <= end;
}

std::optional<Edges> first_of_all_pairs(const std::vector<Point>& line) {
  for (std::size_t i = 0; i + 1 < line.size(); ++i)
    for (std::size_t j = i + 2; j + 1 < line.size(); ++j)
      if (meet(line[i], line[i + 1], line[j], line[j + 1])) return Edges{i, j};
  return std::nullopt;
}

TEST(SelfCrossing, IsTheFirstOfAllPairs) {
  int crossed = 0, simple = 0;
  for (int number = 0; number < 2000; ++number) {
    RandomCase random(number);
    const int size = number % 2 == 0 ? 4 : 30;
    std::vector<Point> line{{0, 0}};
    for (int i = random.whole(3, 12); i > 0; --i) {
      const Point next{1.0 * random.whole(0, size), 1.0 * random.whole(0, size)};
      if (next != line.back()) line.push_back(next);
    }
    const std::optional<Edges> expected = first_of_all_pairs(line);
    ASSERT_EQ(self_crossing(line), expected);
    ++(expected ? crossed : simple);
  }
  EXPECT_GT(crossed, 200);
  EXPECT_GT(simple, 200);
}

TEST(CrossingAlong, IsTheShareOfTheFirstSegment) {
  EXPECT_EQ(crossing_along({0, 0}, {8, 0}, {2, -5}, {2, 5}), 0.25);
  EXPECT_EQ(crossing_along({8, 0}, {0, 0}, {2, -5}, {2, 5}), 0.75);
  EXPECT_EQ(crossing_along({2, -5}, {2, 5}, {0, 0}, {8, 0}), 0.5);
  EXPECT_EQ(crossing_along({0, 0}, {8, 4}, {0, 3}, {6, 0}), 0.375);
}

TEST(CrossingAlong, CountsTheEndsOfBoth) {
  EXPECT_EQ(crossing_along({0, 0}, {8, 0}, {0, -5}, {0, 5}), 0);
  EXPECT_EQ(crossing_along({0, 0}, {8, 0}, {8, -5}, {8, 5}), 1);
  EXPECT_EQ(crossing_along({0, 0}, {8, 0}, {4, 0}, {4, 5}), 0.5);
  EXPECT_EQ(crossing_along({0, 0}, {8, 0}, {4, -5}, {4, 0}), 0.5);
}

TEST(CrossingAlong, IsNoneWhereTheSegmentsMiss) {
  EXPECT_EQ(crossing_along({0, 0}, {8, 0}, {-1, -5}, {-1, 5}), std::nullopt);
  EXPECT_EQ(crossing_along({0, 0}, {8, 0}, {9, -5}, {9, 5}), std::nullopt);
  EXPECT_EQ(crossing_along({0, 0}, {8, 0}, {4, 1}, {4, 5}), std::nullopt);
  EXPECT_EQ(crossing_along({0, 0}, {8, 0}, {4, -5}, {4, -1}), std::nullopt);
  EXPECT_EQ(crossing_along({0, 0}, {8, 0}, {0, 1}, {8, 1}), std::nullopt) << "beside it";
  EXPECT_EQ(crossing_along({0, 0}, {8, 0}, {2, 0}, {5, 0}), std::nullopt) << "along it";
}

}  // namespace tramline::line_crossing_test
