#pragma once
// A closed headland pass to test with.

#include "tramline/model/headland.h"

namespace tramline::testing {

/// Straight sides of these lengths around the origin, and round corners between them, anticlockwise.
inline HeadlandPass rounded_rectangle(double long_m, double wide_m, double radius_m) {
  HeadlandPass out;
  Point at{-long_m / 2, -wide_m / 2 - radius_m}, ahead{1, 0};
  for (int side = 0; side < 4; ++side) {
    const Point next = at + (side % 2 == 0 ? long_m : wide_m) * ahead;
    const Point left{-ahead.y, ahead.x};
    const Point corner = next + radius_m * (ahead + left);
    out.path.push_back({at, next, 0});
    out.path.push_back({next, corner, 1 / radius_m});
    at = corner;
    ahead = left;
  }
  out.path.back().to = out.path.front().from;
  return out;
}

}  // namespace tramline::testing
