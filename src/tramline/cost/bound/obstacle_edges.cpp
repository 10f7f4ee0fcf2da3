#include "tramline/cost/bound/obstacle_edges.h"

#include <algorithm>
#include <iterator>
#include <utility>

#include "tramline/cost/tolerances.h"

namespace tramline {
namespace {

bool lies_on_boundary(Point p, const std::vector<Ring>& rings) {
  return std::any_of(rings.begin(), rings.end(), [p](const Ring& ring) {
    Point from = ring.back();
    return std::any_of(ring.begin(), ring.end(), [&from, p](Point to) {
      const Point start = std::exchange(from, to);
      return distance_to_segment(p, start, to) < kWidthTolerance;
    });
  });
}

}  // namespace

std::vector<bool> edges_at_obstacles(const std::vector<Ring>& outline, const Region& obstacles) {
  std::vector<bool> out;
  for (const Ring& ring : outline) {
    Point from = ring.back();
    for (const Point to : ring) {
      const Point ends[] = {from, to, 0.5 * (from + to)};
      const Box edge = bounds(from, to).grown(kWidthTolerance);
      out.push_back(std::any_of(obstacles.begin(), obstacles.end(), [&](const Polygon& obstacle) {
        if (!intersects(bounds(obstacle), edge)) return false;
        const std::vector<Ring> rings = rings_of({obstacle});
        return std::all_of(std::begin(ends), std::end(ends),
                           [&rings](Point p) { return lies_on_boundary(p, rings); });
      }));
      from = to;
    }
  }
  return out;
}

}  // namespace tramline
