#include "tramline/io/export/thinned_line.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "tramline/geometry/path.h"

namespace tramline::io {
namespace {

/// Distance of a point from a line, by walking along every edge in steps: no formula of the code under test.
double off_line(Point p, const std::vector<Point>& line) {
  constexpr int kSteps = 400;
  double out = HUGE_VAL;
  for (std::size_t i = 0; i + 1 < line.size(); ++i)
    for (int step = 0; step <= kSteps; ++step)
      out = std::min(out,
                     distance(p, line[i] + (static_cast<double>(step) / kSteps) * (line[i + 1] - line[i])));
  return out;
}

double farthest_off(const std::vector<Point>& a, const std::vector<Point>& b) {
  double out = 0;
  for (std::size_t i = 0; i + 1 < a.size(); ++i)
    for (const double share : {0.0, 0.3, 0.5, 0.8})
      out = std::max(out, off_line(a[i] + share * (a[i + 1] - a[i]), b));
  return std::max(out, off_line(a.back(), b));
}

/// A ring of 107 m: two straight sides of 15 m and two half circles of 12.25 m radius.
std::vector<Point> ring_of_107_m() {
  constexpr double r = 12.25;
  return chords({{{0, 0}, {15, 0}, 0},
                 {{15, 0}, {15, 2 * r}, 1 / r},
                 {{15, 2 * r}, {0, 2 * r}, 0},
                 {{0, 2 * r}, {0, 0}, 1 / r}});
}

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
    // Both ways; walking in steps is off by less than 1 mm.
    EXPECT_LE(farthest_off(few, ring), tolerance_m + 1e-3);
    EXPECT_LE(farthest_off(ring, few), tolerance_m + 1e-3);
  }
}

TEST(Thinned, LinesAreThinnedAsArcsAre) {
  // Straight but for 1 cm, with a corner of 90 degrees and a way back along itself.
  const std::vector<Point> line{{0, 0}, {10, 0.01}, {20, 0}, {30, -0.01}, {40, 0}, {40, 30}, {40, 10}};
  EXPECT_EQ(thinned(line, 0.011), (std::vector<Point>{{0, 0}, {40, 0}, {40, 30}, {40, 10}}));
  EXPECT_EQ(thinned(line, 0.009), line);
}

TEST(Thinned, NothingIsLeftOutWithoutATolerance) {
  const std::vector<Point> line{{0, 0}, {1, 0}, {2, 0}};
  EXPECT_EQ(thinned(line, 0), line);
  EXPECT_EQ(thinned(line, 1e-9), (std::vector<Point>{{0, 0}, {2, 0}}));
  EXPECT_EQ(thinned({{3, 4}}, 1), (std::vector<Point>{{3, 4}}));
}

}  // namespace
}  // namespace tramline::io
