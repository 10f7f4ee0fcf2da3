#include "tramline/geometry/polygon/bounding_rectangle.h"

#include <algorithm>
#include <cassert>
#include <tuple>

#include "tramline/geometry/tolerances.h"

namespace tramline {
namespace {

struct Extents {
  Direction direction;  ///< of the hull edge
  double along, across;
};

std::vector<Extents> extents_by_hull_edge(const Ring& ring) {
  const Ring hull = hull_of(ring);
  std::vector<Extents> out;
  for (std::size_t i = 0; i < hull.size(); ++i) {
    const Point a = hull[i], b = hull[(i + 1) % hull.size()];
    const Point unit = (1 / distance(a, b)) * (b - a);
    double min_along = 0, max_along = 0, max_across = 0;
    for (const Point p : hull) {
      min_along = std::min(min_along, dot(unit, p - a));
      max_along = std::max(max_along, dot(unit, p - a));
      max_across = std::max(max_across, cross(unit, p - a));
    }
    out.push_back({Direction::along(a, b), max_along - min_along, max_across});
  }
  return out;
}

double short_side(const Extents& edge) { return std::min(edge.along, edge.across); }

/// The least value wins; among equals (relative kRounding_share) the slimmest rectangle, then the smallest
/// direction. All rectangles on a triangle's edges have the same area, so ties are common, and the
/// slimmest does not depend on how the frame lies.
template <class Value, class Axis>
Direction least(const std::vector<Extents>& edges, Value value, Axis axis) {
  constexpr double kTie = 1 + kRounding_share;
  double least_value = std::numeric_limits<double>::infinity();
  for (const Extents& edge : edges) least_value = std::min(least_value, value(edge));
  double least_side = std::numeric_limits<double>::infinity();
  for (const Extents& edge : edges)
    if (value(edge) <= least_value * kTie) least_side = std::min(least_side, short_side(edge));
  Direction best;
  bool found = false;
  for (const Extents& edge : edges) {
    if (value(edge) > least_value * kTie || short_side(edge) > least_side * kTie) continue;
    const Direction candidate = axis(edge);
    if (!found || candidate < best) best = candidate;
    found = true;
  }
  return best;
}

}  // namespace

Ring hull_of(std::vector<Point> points) {
  std::sort(points.begin(), points.end(),
            [](Point a, Point b) { return std::tie(a.x, a.y) < std::tie(b.x, b.y); });
  points.erase(std::unique(points.begin(), points.end()), points.end());
  if (points.size() < 3) return points;
  Ring hull;
  const auto grow = [&hull](Point p, std::size_t keep) {
    while (hull.size() >= keep + 2 && cross(hull.back() - hull[hull.size() - 2], p - hull.back()) <= 0)
      hull.pop_back();
    hull.push_back(p);
  };
  for (const Point p : points) grow(p, 0);
  const std::size_t lower = hull.size() - 1;
  for (auto p = points.rbegin() + 1; p != points.rend(); ++p) grow(*p, lower);
  hull.pop_back();
  return hull;
}

Direction long_side_of_smallest_rectangle(const Ring& ring) {
  assert(signed_area(ring) != 0);
  return least(
      extents_by_hull_edge(ring), [](const Extents& e) { return e.along * e.across; },
      [](const Extents& e) { return e.along >= e.across ? e.direction : e.direction.perpendicular(); });
}

Direction across_least_width(const Ring& ring) {
  assert(signed_area(ring) != 0);
  return least(
      extents_by_hull_edge(ring), [](const Extents& e) { return e.across; },
      [](const Extents& e) { return e.direction; });
}

}  // namespace tramline
