// Reference lines of every kind, tidy and not: what comes out can be driven, or the input is said to be at
// fault.

#include <gtest/gtest.h>

#include <cmath>

#include "geometry/drivable.h"
#include "properties/draws.h"
#include "properties/random_field.h"
#include "properties/seeds.h"
#include "tramline/geometry/error.h"
#include "tramline/geometry/path/smoothed_line.h"

namespace tramline {
namespace {

/// A walk with noise of some size at every point, some points twice, some all but twice.
std::vector<Point> random_walk(std::mt19937_64& random) {
  const double step = std::pow(10, uniform(random, -2, 2)), bend = uniform(random, 0, 1);
  const double noise = any_of(random, 0, 1) * std::pow(10, uniform(random, -4, -0.3)) * step;
  std::vector<Point> out;
  Point at{uniform(random, -1e3, 1e3), uniform(random, -1e3, 1e3)};
  double heading = uniform(random, -3, 3);
  for (int i = any_of(random, 1, 200); i >= 0; --i) {
    out.push_back(at + Point{uniform(random, -noise, noise), uniform(random, -noise, noise)});
    if (any_of(random, 0, 15) == 0) out.push_back(out.back());
    if (any_of(random, 0, 15) == 0) out.push_back(out.back() + Point{1e-7, -1e-6});
    heading += uniform(random, -bend, bend);
    at = at + step * uniform(random, 0.01, 1) * Point{std::cos(heading), std::sin(heading)};
  }
  return out;
}

TEST(SmoothedProperties, CanBeDrivenOrSaysWhy) {
  int driven = 0;
  const int cases = testing::case_count(600);
  for (int i = 0; i < cases; ++i) {
    testing::SeededRandom random(i);
    const std::vector<Point> line = random_walk(random);
    const double radius = uniform(random, 0.5, 12), tolerance = any_of(random, 0, 1) * uniform(random, 0, 1);
    try {
      const Smoothed out = smoothed(line, radius, tolerance);
      ++driven;
      expect_drivable(out.path, radius);
      EXPECT_EQ(out.path.front().from, line.front());
      EXPECT_EQ(out.path.back().to, line.back());
      // The deviation is what it says it is: no vertex lies farther off.
      for (const Point p : line) {
        double least = 1e9;
        for (const PathSegment& segment : out.path) least = std::min(least, distance_to_edge(segment, p, p));
        EXPECT_LE(least, out.deviation_m + 1e-3);
      }
    } catch (const Error& error) {
      EXPECT_EQ(error.kind(), ErrorKind::kBadInput) << error.what();
    }
    if (::testing::Test::HasFailure()) return;
  }
  EXPECT_GE(3 * driven, cases < 100 ? 0 : cases);
}

}  // namespace
}  // namespace tramline
