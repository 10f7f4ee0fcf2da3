#include "tramline/geometry/polygon/smallest_disc.h"

#include <cassert>
#include <cmath>
#include <cstddef>

#include "tramline/geometry/tolerances.h"

namespace tramline {
namespace {

bool contains(const Disc& disc, Point p) {
  return distance(disc.centre, p) <= disc.radius_m + kSameDistance_m;
}

Disc between(Point a, Point b) { return {midpoint(a, b), 0.5 * distance(a, b)}; }

/// Through three points; where they lie on a line, between the first and the last.
Disc through(Point a, Point b, Point c) {
  const Point u = b - a, v = c - a;
  const double twice = 2 * cross(u, v);
  if (twice == 0) return between(a, c);
  const double uu = dot(u, u), vv = dot(v, v);
  const Point off{(v.y * uu - u.y * vv) / twice, (u.x * vv - v.x * uu) / twice};
  return {a + off, length(off)};
}

}  // namespace

Disc smallest_disc(const std::vector<Point>& points) {
  assert(!points.empty());
  Disc disc{points.front(), 0};
  for (std::size_t i = 1; i < points.size(); ++i) {
    if (contains(disc, points[i])) continue;
    disc = {points[i], 0};
    for (std::size_t j = 0; j < i; ++j) {
      if (contains(disc, points[j])) continue;
      disc = between(points[i], points[j]);
      for (std::size_t k = 0; k < j; ++k)
        if (!contains(disc, points[k])) disc = through(points[i], points[k], points[j]);
    }
  }
  return disc;
}

}  // namespace tramline
