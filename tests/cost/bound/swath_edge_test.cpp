// The inner edge of a detour's swath, against the distances of places from a path of two arcs.

#include "tramline/cost/bound/swath_edge.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tramline/geometry/point.h"

namespace tramline {
namespace {

/// The path that leaves its farthest place by an arc and comes back to the track by another: its points, one
/// every few centimetres, from the place to beyond its end.
std::vector<Point> path_of_two_arcs(double aside_m, double arc_m) {
  const double angle = std::acos(1 - aside_m / (2 * arc_m));
  const double length_m = 2 * arc_m * std::sin(angle);
  std::vector<Point> out;
  constexpr int kPoints = 200;
  for (int i = 0; i <= kPoints; ++i) {
    const double turned = angle * i / kPoints;
    out.push_back({aside_m - arc_m * (1 - std::cos(turned)), arc_m * std::sin(turned)});
  }
  for (int i = kPoints; i >= 0; --i) {
    const double turned = angle * i / kPoints;
    out.push_back({arc_m * (1 - std::cos(turned)), length_m - arc_m * std::sin(turned)});
  }
  for (int i = 0; i < 300; ++i) out.push_back({0, length_m + 0.05 * i});
  return out;
}

/// Land of the strip at coordinates along of `from` to `to` that is half a width from the path or farther.
double by_distances_m2(const std::vector<Point>& path, double width_m, double from, double to) {
  constexpr double kStep_m = 0.05;
  int count = 0;
  for (double y = from + 0.5 * kStep_m; y < to; y += kStep_m)
    for (double x = -0.5 * width_m + 0.5 * kStep_m; x < 0.5 * width_m; x += kStep_m) {
      bool is_worked = false;
      for (const Point p : path) is_worked = is_worked || distance(p, {x, y}) < 0.5 * width_m;
      count += is_worked ? 0 : 1;
    }
  return count * kStep_m * kStep_m;
}

/// What the strip has beside the edge in those rows, by the lower end of each row.
double beside_the_edge_m2(const PassedPlace& place, double from, double to) {
  constexpr double kStep_m = 0.05;
  double sum = 0;
  for (double y = from; y < to; y += kStep_m)
    sum +=
        kStep_m * std::clamp(inner_edge_m(place, y - place.along) + 0.5 * place.width_m, 0.0, place.width_m);
  return sum;
}

TEST(SwathEdge, BoundsWhatTheSwathAlongTwoArcsLeaves) {
  for (const double aside_m : {0.5, 1.5, 4.0, 9.0}) {
    const PassedPlace place{0, aside_m, 6, 3, 0};
    const double exact_m2 = by_distances_m2(path_of_two_arcs(aside_m, 6), 3, 0, 12);
    const double least_m2 = beside_the_edge_m2(place, 0, 12);
    // The sampled swath is open, and samples of the path are centimetres apart.
    EXPECT_LE(least_m2, exact_m2 + 0.3) << aside_m;
    EXPECT_GE(least_m2, 0.95 * exact_m2 - 0.3) << aside_m;
  }
}

// At the place itself the edge lies half a width inside the line; two radii away the arcs have ended.
TEST(SwathEdge, LiesHalfAWidthInsideTheLineAndEndsOnTheTrack) {
  const PassedPlace place{100, 3, 6, 3, 0};
  EXPECT_NEAR(inner_edge_m(place, 0), 1.5, 1e-12);
  EXPECT_EQ(inner_edge_m(place, 12), -1.5);
  for (double away_m = 0.1; away_m < 12; away_m += 0.1)
    EXPECT_LE(inner_edge_m(place, away_m), inner_edge_m(place, away_m - 0.1) + 1e-12);
}

}  // namespace
}  // namespace tramline
