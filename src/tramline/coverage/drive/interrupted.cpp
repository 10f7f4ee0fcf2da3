#include "tramline/coverage/drive/interrupted.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace tramline::coverage {
namespace {

/// The part of a convex ring on the left of the line from a to b.
Ring left_part(const Ring& ring, Point a, Point b) {
  Ring out;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Point from = ring[i], to = ring[i + 1 < ring.size() ? i + 1 : 0];
    const double before = cross(b - a, from - a), after = cross(b - a, to - a);
    if (before >= 0) out.push_back(from);
    if ((before > 0 && after < 0) || (before < 0 && after > 0))
      out.push_back(from + before / (before - after) * (to - from));
  }
  return out;
}

bool is_ground(const Ring& ring) { return ring.size() >= 3 && std::abs(signed_area(ring)) > 1e-9; }

Point middle(const Ring& ring) {
  Point sum;
  for (const Point p : ring) sum = sum + p;
  return (1 / static_cast<double>(ring.size())) * sum;
}

/// Cut along the lines of all edges of the region that meet the quad, so that each cell lies on it or not.
std::vector<Ring> cells_of(const Quad& quad, const Region& region) {
  std::vector<Ring> cells{Ring(quad.begin(), quad.end())};
  Box box;
  for (const Point p : quad) box.extend(p);
  for (const Ring& ring : rings_of(region))
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const Point a = ring[i], b = ring[i + 1 < ring.size() ? i + 1 : 0];
      if (!intersects(bounds(a, b), box)) continue;
      std::vector<Ring> cut;
      for (const Ring& cell : cells)
        for (const Ring& part : {left_part(cell, a, b), left_part(cell, b, a)})
          if (is_ground(part)) cut.push_back(part);
      cells = std::move(cut);
    }
  return cells;
}

void append_fan(const Ring& cell, std::vector<Quad>& out) {
  for (std::size_t i = 1; i + 1 < cell.size(); i += 2)
    out.push_back({cell[0], cell[i], cell[i + 1], i + 2 < cell.size() ? cell[i + 2] : cell[i + 1]});
}

}  // namespace

std::vector<Quad> interrupted(const std::vector<Quad>& quads, const Region& region) {
  const Box near = bounds(region);
  std::vector<Quad> out;
  for (const Quad& quad : quads) {
    Box box;
    for (const Point p : quad) box.extend(p);
    if (!intersects(box, near)) {
      out.push_back(quad);
      continue;
    }
    for (const Ring& cell : cells_of(quad, region)) {
      const Point inside = middle(cell);
      const bool on_it = std::any_of(region.begin(), region.end(),
                                     [&](const Polygon& polygon) { return contains(polygon, inside); });
      if (!on_it) append_fan(cell, out);
    }
  }
  return out;
}

}  // namespace tramline::coverage
