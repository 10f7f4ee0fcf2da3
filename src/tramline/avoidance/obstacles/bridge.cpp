#include "tramline/avoidance/obstacles/bridge.h"

#include <algorithm>

#include "tramline/geometry/polygon/boolean.h"

namespace tramline {
namespace {

/// The point of segment ab nearest to p.
Point foot(Point p, Point a, Point b) {
  const Point along = b - a;
  return a + std::clamp(dot(p - a, along) / dot(along, along), 0.0, 1.0) * along;
}

/// The region's part near one edge, and its projections on the edge.
std::vector<Point> near_points_and_feet(const Region& near_part, Point a, Point b) {
  std::vector<Point> out;
  for (const Polygon& polygon : near_part)
    for (const Point p : polygon.outer) {
      out.push_back(p);
      out.push_back(foot(p, a, b));
    }
  return out;
}

}  // namespace

Region bridge(const Ring& ring, const Region& region, double gap_m) {
  // The chords of a round buffer run inside the circle; one percent more compensates for that.
  const double reach = 1.01 * gap_m;
  const Box near_box = bounds(region).grown(reach);
  Region out;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Point a = ring[i], b = ring[(i + 1) % ring.size()];
    if (a == b || !intersects(bounds(a, b), near_box)) continue;
    const Region near_edge = line_neighbourhood(a, b, reach);
    // One by one: polygons that touch along an edge are not valid input together.
    for (const Polygon& polygon : region)
      for (const Polygon& part : intersection({polygon}, near_edge))
        for (Polygon& hull : convex_hull(near_points_and_feet({part}, a, b))) out.push_back(std::move(hull));
  }
  return unite(out);
}

}  // namespace tramline
