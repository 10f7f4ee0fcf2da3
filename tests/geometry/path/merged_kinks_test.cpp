#include "tramline/geometry/path/merged_kinks.h"

#include <gtest/gtest.h>

#include "geometry/random_shapes.h"

namespace tramline::merged_kinks_test {

using testing::RandomCase;

constexpr double kPi = std::numbers::pi;

void expect_line(const std::vector<Point>& found, const std::vector<Point>& expected) {
  ASSERT_EQ(found.size(), expected.size());
  for (std::size_t i = 0; i < found.size(); ++i) EXPECT_LT(distance(found[i], expected[i]), 1e-9) << i;
}

TEST(TurnAt, IsLeftPositive) {
  EXPECT_NEAR(turn_at({0, 0}, {5, 0}, {5, 9}), kPi / 2, 1e-12);
  EXPECT_NEAR(turn_at({0, 0}, {5, 0}, {5, -9}), -kPi / 2, 1e-12);
  EXPECT_NEAR(turn_at({0, 0}, {5, 0}, {4, 1}), 3 * kPi / 4, 1e-12);
  EXPECT_EQ(turn_at({0, 0}, {5, 0}, {6, 0}), 0);
  EXPECT_NEAR(std::abs(turn_at({0, 0}, {5, 0}, {1, 0})), kPi, 1e-12);
}

TEST(MergedKinks, LeavesALineWithRoomAlone) {
  // At 90° the tangent is as long as the radius: 6 + 6 m of 12.
  const std::vector<Point> line{{0, 0}, {6, 0}, {6, 12}, {0, 12}};
  const MergedKinks merged = merged_kinks(line, 6);
  EXPECT_EQ(merged.line, line);
  EXPECT_FALSE(merged.hairpin);
  EXPECT_EQ(merged_kinks({{0, 0}, {1, 0}}, 6).line, (std::vector<Point>{{0, 0}, {1, 0}}));
}

// Two turns of 45° on an edge too short for both: one of 90° where the edges beside it meet.
TEST(MergedKinks, UnitesTurnsToOneSideWhereTheirNeighboursMeet) {
  const MergedKinks merged = merged_kinks({{0, 0}, {100, 0}, {101, 1}, {101, 100}}, 6);
  EXPECT_FALSE(merged.hairpin);
  expect_line(merged.line, {{0, 0}, {101, 0}, {101, 100}});
}

// A step of 1 m to the left: both kinks stay on their edges, and as near to one another as their arcs allow.
TEST(MergedKinks, DrawsOppositeTurnsApart) {
  const double radius = 6;
  const MergedKinks merged = merged_kinks({{0, 0}, {100, 0}, {101, 1}, {200, 1}}, radius);
  EXPECT_FALSE(merged.hairpin);
  ASSERT_EQ(merged.line.size(), 4U);
  const Point p = merged.line[1], q = merged.line[2];
  EXPECT_NEAR(p.y, 0, 1e-9);
  EXPECT_NEAR(q.y, 1, 1e-9);
  EXPECT_NEAR(100 - p.x, q.x - 101, 1e-9) << "both by as much";
  const double turn = std::atan2(1, q.x - p.x);
  EXPECT_NEAR(distance(p, q), 2 * radius * std::tan(0.5 * turn), 2e-3);
  EXPECT_GE(distance(p, q), 2 * radius * std::tan(0.5 * turn));
}

// The same step 7.6 m behind a turn of 90°, whose arc takes 6 m: drawn apart by 0.7 m, with tangents of 1.1
// m, its kinks would want 0.2 m more than there are. Of a step this small the middle is left.
TEST(MergedKinks, LevelsAStepWithoutRoomToDrawItApart) {
  const MergedKinks merged = merged_kinks({{0, 100}, {0, 0}, {7.6, 0}, {8.6, 1}, {108.6, 1}}, 6);
  EXPECT_FALSE(merged.hairpin);
  expect_line(merged.line, {{0, 100}, {0, 0}, {8.1, 0.5}, {108.6, 1}});
}

TEST(MergedKinks, DropsAKinkNextToAnEndThatIsNear) {
  expect_line(merged_kinks({{0, 0}, {1, 0}, {1, 100}}, 6).line, {{0, 0}, {1, 100}});
  expect_line(merged_kinks({{1, 100}, {1, 0}, {0, 0}}, 6).line, {{1, 100}, {0, 0}});
}

TEST(MergedKinks, NamesAHairpin) {
  EXPECT_EQ(merged_kinks({{-50, 0}, {0, 0}, {100, 0}, {0, 5}}, 6).hairpin, 2U) << "177 degrees";
  // 165° to the left with room, and then without: the tangents are 7.6 radii long.
  const Point back = 100 * Point{std::cos(165 * kPi / 180), std::sin(165 * kPi / 180)};
  EXPECT_FALSE(merged_kinks({{-100, 0}, {0, 0}, back}, 6).hairpin);
  EXPECT_EQ(merged_kinks({{-100, 0}, {0, 0}, 0.3 * back}, 6).hairpin, 1U);
}

/// Length of the arc's tangents at b, from the half-angle between the edges instead of the turn.
double tangent(Point a, Point b, Point c, double radius) {
  const double cosine = dot(a - b, c - b) / (distance(a, b) * distance(b, c));
  return radius / std::tan(0.5 * std::acos(std::clamp(cosine, -1.0, 1.0)));
}

double least_room(const std::vector<Point>& line, double radius) {
  std::vector<double> tangents(line.size(), 0);
  for (std::size_t i = 1; i + 1 < line.size(); ++i)
    tangents[i] = tangent(line[i - 1], line[i], line[i + 1], radius);
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i + 1 < line.size(); ++i)
    least = std::min(least, distance(line[i], line[i + 1]) - tangents[i] - tangents[i + 1]);
  return least;
}

TEST(MergedKinks, HasRoomForAllArcsOrAHairpin) {
  int changed = 0, unchanged = 0, hairpins = 0;
  for (int number = 0; number < 1000; ++number) {
    RandomCase random(number);
    const double radius = random.between(0.5, 12), sharpest = random.between(0.1, 2.5);
    std::vector<Point> line{{0, 0}};
    Point direction{1, 0};
    for (int i = random.whole(1, 30); i > 0; --i) {
      line.push_back(line.back() + random.between(0.5, 30) * direction);
      direction = turned(direction, random.between(-sharpest, sharpest));
    }
    const MergedKinks merged = merged_kinks(line, radius);
    if (merged.hairpin) {
      ++hairpins;
      continue;
    }
    ASSERT_GE(merged.line.size(), 2U);
    EXPECT_EQ(merged.line.front(), line.front());
    EXPECT_EQ(merged.line.back(), line.back());
    EXPECT_GE(least_room(merged.line, radius), -1e-6);
    if (least_room(line, radius) > 1e-6) {
      EXPECT_EQ(merged.line, line);
      ++unchanged;
    } else {
      ++changed;
    }
  }
  EXPECT_GT(changed, 100);
  EXPECT_GT(unchanged, 50);
  EXPECT_GT(hairpins, 10);
}

}  // namespace tramline::merged_kinks_test
