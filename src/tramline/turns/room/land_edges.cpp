#include "tramline/turns/room/land_edges.h"

#include <algorithm>
#include <cmath>

#include "tramline/turns/outline/tolerances.h"

namespace tramline {
namespace {

Ring without_doubles(const Ring& ring) {
  Ring out;
  for (const Point p : ring)
    if (out.empty() || distance(out.back(), p) > kTouchesEdge_m) out.push_back(p);
  while (out.size() > 1 && distance(out.back(), out.front()) <= kTouchesEdge_m) out.pop_back();
  return out;
}

/// The land lies on the left of the ring.
Ring moved_outwards(const Ring& given, double by_m) {
  const Ring ring = without_doubles(given);
  Ring out;
  if (ring.size() < 3) return out;
  out.reserve(ring.size());
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Point in = ring[i] - ring[(i + ring.size() - 1) % ring.size()];
    const Point on = ring[(i + 1) % ring.size()] - ring[i];
    const Point one = right_of((1 / length(in)) * in), other = right_of((1 / length(on)) * on);
    // |one + other| = 2 cos(half the turn), and the mitre is 1/cos of it long
    const double share = std::max(1 + dot(one, other), 1 / (kFarthestMitre * kFarthestMitre));
    const Point mitre = (1 / share) * (one + other);
    const double too_long = length(mitre) / kFarthestMitre;
    out.push_back(ring[i] + (by_m / std::max(1.0, too_long)) * mitre);
  }
  return out;
}

}  // namespace

Region slightly_grown(const Region& land, double by_m) {
  Region out;
  for (const Polygon& given : land) {
    const Polygon polygon = oriented(given);
    Polygon grown{moved_outwards(polygon.outer, by_m), {}};
    if (grown.outer.empty()) continue;
    for (const Ring& hole : polygon.holes)
      if (Ring ring = moved_outwards(hole, by_m); !ring.empty()) grown.holes.push_back(std::move(ring));
    out.push_back(std::move(grown));
  }
  return out;
}

bool LandEdges::contains(Point p) const {
  const Box& all = grid().bounds();
  if (edges().empty() || !(p.x <= all.max_x)) return false;
  bool inside = false;
  grid().each_meeting({p.x, p.y, all.max_x, p.y}, [&](std::size_t i) {
    const EdgeIndex::Edge& edge = edges()[i];
    if ((edge.from.y > p.y) == (edge.to.y > p.y)) return;
    const double share = (p.y - edge.from.y) / (edge.to.y - edge.from.y);
    if (edge.from.x + share * (edge.to.x - edge.from.x) > p.x) inside = !inside;
  });
  return inside;
}

bool LandEdges::lie_between(Point a, Point b) const {
  constexpr double kInLine_m = 1e-9;
  const Point way = b - a;
  bool odd = false, in_line = false;
  // On which side of the line along a vector a point is. A vector is no longer than the sum of its
  // components.
  const auto is_left = [&in_line](double twice_area_m2, Point along) {
    if (std::abs(twice_area_m2) <= kInLine_m * (std::abs(along.x) + std::abs(along.y)) &&
        std::abs(twice_area_m2) <= kInLine_m * length(along))
      in_line = true;
    return twice_area_m2 > 0;
  };
  grid().each_meeting(
      {std::min(a.x, b.x), std::min(a.y, b.y), std::max(a.x, b.x), std::max(a.y, b.y)}, [&](std::size_t i) {
        const EdgeIndex::Edge& edge = edges()[i];
        const Point along = edge.to - edge.from;
        const bool ends_apart =
            is_left(cross(way, edge.from - a), way) != is_left(cross(way, edge.to - a), way);
        const bool points_apart =
            is_left(cross(along, a - edge.from), along) != is_left(cross(along, b - edge.from), along);
        if (ends_apart && points_apart) odd = !odd;
      });
  return in_line ? contains(a) != contains(b) : odd;
}

}  // namespace tramline
