#include "tramline/geometry/polygon/interior_point.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace tramline {
namespace {

void add_crossings(const Ring& ring, double y, std::vector<double>& xs) {
  for (std::size_t i = 0, j = ring.size() - 1; i < ring.size(); j = i++) {
    const Point a = ring[j], b = ring[i];
    if ((a.y > y) != (b.y > y)) xs.push_back(a.x + (b.x - a.x) * (y - a.y) / (b.y - a.y));
  }
}

/// A height near the middle that passes between vertices rather than through one.
double clear_height(const Polygon& polygon) {
  const Box box = bounds(polygon);
  const double middle = box.centre().y;
  double below = box.min_y, above = box.max_y;
  for (const Ring& ring : rings_of({polygon}))
    for (const Point p : ring) {
      if (p.y <= middle) below = std::max(below, p.y);
      if (p.y > middle) above = std::min(above, p.y);
    }
  return 0.5 * (below + above);
}

}  // namespace

Point interior_point(const Polygon& polygon) {
  assert(polygon.outer.size() >= 3);
  const double y = clear_height(polygon);
  std::vector<double> xs;
  for (const Ring& ring : rings_of({polygon})) add_crossings(ring, y, xs);
  std::sort(xs.begin(), xs.end());
  Point best = polygon.outer.front();
  double widest = -1;
  for (std::size_t i = 0; i + 1 < xs.size(); i += 2)
    if (xs[i + 1] - xs[i] > widest) {
      widest = xs[i + 1] - xs[i];
      best = {0.5 * (xs[i] + xs[i + 1]), y};
    }
  return best;
}

}  // namespace tramline
