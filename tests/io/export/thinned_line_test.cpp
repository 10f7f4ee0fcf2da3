#include "tramline/io/export/thinned_line.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "tramline/geometry/path/path.h"

namespace tramline::io {
namespace {

double off_segment(Point p, Point a, Point b) {
  if (dot(p - a, b - a) <= 0) return distance(p, a);
  if (dot(p - b, a - b) <= 0) return distance(p, b);
  return std::abs(cross(b - a, p - a)) / distance(a, b);
}

double off_line(Point p, const std::vector<Point>& line) {
  double out = HUGE_VAL;
  for (std::size_t i = 0; i + 1 < line.size(); ++i) out = std::min(out, off_segment(p, line[i], line[i + 1]));
  return out;
}

/// A ring of 107 m: two straight sides of 15 m and two half circles of 12.25 m radius.
std::vector<Point> ring_of_107_m() {
  constexpr double r = 12.25;
  return chords({{{0, 0}, {15, 0}, 0},
                 {{15, 0}, {15, 2 * r}, 1 / r},
                 {{15, 2 * r}, {0, 2 * r}, 0},
                 {{0, 2 * r}, {0, 0}, 1 / r}});
}

/// How far a point lies from that ring: all of it is r from its axis.
double off_ring(Point p) { return std::abs(off_segment(p, {0, 12.25}, {15, 12.25}) - 12.25); }

TEST(Thinned, ARingOf107MetresNeedsFewPoints) {
  const std::vector<Point> ring = ring_of_107_m();
  ASSERT_GT(ring.size(), 1500U);
  for (const double tolerance_m : {0.005, 0.01, 0.02, 0.5}) {
    SCOPED_TRACE(tolerance_m);
    const std::vector<Point> few = thinned(ring, tolerance_m);
    EXPECT_EQ(few.front(), ring.front());
    EXPECT_EQ(few.back(), ring.back());
    // A chord with that sagitta spans 2·acos(1 − t/r); halving the way finds at worst twice as many.
    const double most = 2 * std::numbers::pi / std::acos(1 - tolerance_m / 12.25) + 4;
    EXPECT_LE(static_cast<double>(few.size()), most);
    // Both ways; the ring itself is of chords.
    for (std::size_t i = 0; i + 1 < few.size(); ++i)
      for (const double share : {0.0, 0.25, 0.5, 0.9})
        EXPECT_LE(off_ring(few[i] + share * (few[i + 1] - few[i])), tolerance_m + kChordSagitta);
    for (const Point p : ring) EXPECT_LE(off_line(p, few), tolerance_m);
  }
}

TEST(Thinned, LinesAreThinnedAsArcsAre) {
  // Straight but for 1 cm, with a corner of 90 degrees and a way back along itself.
  const std::vector<Point> line{{0, 0}, {10, 0.01}, {20, 0}, {30, -0.01}, {40, 0}, {40, 30}, {40, 10}};
  EXPECT_EQ(thinned(line, 0.011), (std::vector<Point>{{0, 0}, {40, 0}, {40, 30}, {40, 10}}));
  // The third lies on the way from the second to the fourth.
  EXPECT_EQ(thinned(line, 0.009),
            (std::vector<Point>{{0, 0}, {10, 0.01}, {30, -0.01}, {40, 0}, {40, 30}, {40, 10}}));
}

TEST(Thinned, NothingIsLeftOutWithoutATolerance) {
  const std::vector<Point> line{{0, 0}, {1, 0}, {2, 0}};
  EXPECT_EQ(thinned(line, 0), line);
  EXPECT_EQ(thinned(line, 1e-9), (std::vector<Point>{{0, 0}, {2, 0}}));
  EXPECT_EQ(thinned({{3, 4}}, 1), (std::vector<Point>{{3, 4}}));
}

}  // namespace
}  // namespace tramline::io
