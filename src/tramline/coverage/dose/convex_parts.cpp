#include "tramline/coverage/dose/convex_parts.h"

#include <algorithm>
#include <optional>
#include <utility>

namespace tramline::coverage {
namespace {

SmallPolygon triangle(Point a, Point b, Point c) {
  SmallPolygon out;
  out.add(a);
  out.add(b);
  out.add(c);
  if (cross(b - a, c - a) < 0) std::swap(out.corners[1], out.corners[2]);
  return out;
}

/// Twice the area of the triangle at the corner, positive for a turn to the left.
double turn(const Quad& quad, std::size_t corner) {
  const Point before = quad[(corner + 3) % 4], at = quad[corner], after = quad[(corner + 1) % 4];
  return cross(at - before, after - at);
}

/// Where the sides a–b and c–d cross, if they do.
std::optional<Point> crossing(Point a, Point b, Point c, Point d) {
  const double from = cross(d - c, a - c), to = cross(d - c, b - c);
  const double other_from = cross(b - a, c - a), other_to = cross(b - a, d - a);
  if (!(from * to < 0) || !(other_from * other_to < 0)) return std::nullopt;
  return a + from / (from - to) * (b - a);
}

}  // namespace

double area(const SmallPolygon& polygon) {
  double twice = 0;
  for (std::size_t i = 2; i < polygon.size; ++i)
    twice += cross(polygon.corners[i - 1] - polygon.corners[0], polygon.corners[i] - polygon.corners[0]);
  return 0.5 * twice;
}

std::vector<SmallPolygon> convex_parts(const Quad& q) {
  std::array<double, 4> turns{};
  for (std::size_t i = 0; i < 4; ++i) turns[i] = turn(q, i);
  const auto lefts = std::count_if(turns.begin(), turns.end(), [](double t) { return t >= 0; });
  const auto rights = std::count_if(turns.begin(), turns.end(), [](double t) { return t <= 0; });
  if (lefts == 4 || rights == 4) {
    SmallPolygon out;
    for (std::size_t i = 0; i < 4; ++i) out.add(q[lefts == 4 ? i : 3 - i]);
    return {out};
  }
  if (const auto x = crossing(q[1], q[2], q[3], q[0]))
    return {triangle(q[0], q[1], *x), triangle(q[2], q[3], *x)};
  if (const auto x = crossing(q[0], q[1], q[2], q[3]))
    return {triangle(q[1], q[2], *x), triangle(q[3], q[0], *x)};
  // An arrow: cut at the corner that turns the other way.
  const bool from_first = cross(q[1] - q[0], q[2] - q[0]) * cross(q[2] - q[0], q[3] - q[0]) >= 0;
  if (from_first) return {triangle(q[0], q[1], q[2]), triangle(q[0], q[2], q[3])};
  return {triangle(q[1], q[2], q[3]), triangle(q[1], q[3], q[0])};
}

}  // namespace tramline::coverage
