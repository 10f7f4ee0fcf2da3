#include "tramline/avoidance/bridge.h"

#include "tramline/geometry/boolean.h"

namespace tramline {
namespace {

void append_points(const Region& region, std::vector<Point>& out) {
  for (const Polygon& polygon : region) out.insert(out.end(), polygon.outer.begin(), polygon.outer.end());
}

}  // namespace

Region bridge(const Ring& ring, const Region& region, double gap_m) {
  // The chords of a round buffer run inside the circle; a percent more makes up for them.
  const double reach = 1.01 * gap_m;
  const Region near_region = buffered(region, reach);
  const Box near_box = bounds(near_region);
  Region out;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Point a = ring[i], b = ring[(i + 1) % ring.size()];
    Box edge_box;
    edge_box.extend(a);
    edge_box.extend(b);
    if (!intersects(edge_box, near_box)) continue;
    for (const auto& part : parts_inside(near_region, a, b)) {
      std::vector<Point> corners = part;
      append_points(intersection(region, buffered_line(part, reach)), corners);
      for (Polygon& hull : convex_hull(corners)) out.push_back(std::move(hull));
    }
  }
  return unite(out);
}

}  // namespace tramline
