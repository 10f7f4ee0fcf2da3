#include "tramline/geometry/convex_clip.h"

namespace tramline {
namespace {

/// Keeps what lies left of the line a → b.
Ring clipped_by_line(const Ring& ring, Point a, Point b) {
  Ring out;
  if (ring.empty()) return out;
  out.reserve(ring.size() + 4);
  const Point direction = b - a;
  Point previous = ring.back();
  double previous_side = cross(direction, previous - a);
  for (const Point current : ring) {
    const double side = cross(direction, current - a);
    if ((side >= 0) != (previous_side >= 0)) {
      const double t = previous_side / (previous_side - side);
      out.push_back(previous + t * (current - previous));
    }
    if (side >= 0) out.push_back(current);
    previous = current;
    previous_side = side;
  }
  return out;
}

Ring clipped_by_convex(Ring ring, const Ring& convex) {
  for (std::size_t i = 0; i < convex.size() && !ring.empty(); ++i)
    ring = clipped_by_line(ring, convex[i], convex[(i + 1) % convex.size()]);
  return ring;
}

}  // namespace

RingSet clipped(const RingSet& rings, const Ring& convex) {
  RingSet out;
  const Box box = bounds(convex);
  for (const Ring& ring : rings) {
    if (!intersects(bounds(ring), box)) continue;
    Ring part = clipped_by_convex(ring, convex);
    if (part.size() >= 3) out.push_back(std::move(part));
  }
  return out;
}

Ring convex_intersection(const Ring& a, const Ring& b) {
  if (!intersects(bounds(a), bounds(b))) return {};
  Ring out = clipped_by_convex(a, b);
  return out.size() >= 3 ? out : Ring{};
}

double signed_area(const RingSet& rings) {
  double sum = 0;
  for (const Ring& ring : rings) sum += signed_area(ring);
  return sum;
}

double area_in_union(const RingSet& rings, const std::vector<Ring>& convex) {
  double sum = 0;
  for (std::size_t k = 0; k < convex.size(); ++k) {
    const RingSet inside = clipped(rings, convex[k]);
    if (inside.empty()) continue;
    sum += signed_area(inside);
    std::vector<Ring> later;
    for (std::size_t j = k + 1; j < convex.size(); ++j) {
      Ring both = convex_intersection(convex[j], convex[k]);
      if (signed_area(both) > 0) later.push_back(std::move(both));
    }
    if (!later.empty()) sum -= area_in_union(inside, later);
  }
  return sum;
}

}  // namespace tramline
