#include "tramline/geometry/polygon/convex_clip.h"

#include <algorithm>
#include <cassert>

namespace tramline {
namespace {

/// Keeps what lies left of the line a → b.
void clip_by_line(const Ring& ring, Point a, Point b, Ring& out) {
  out.clear();
  if (ring.empty()) return;
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
}

/// The ring within all edges of the set. Refers to storage that the next call reuses: searches clip too often
/// for a ring of its own at every edge.
const Ring& clipped_by_set(const Ring& ring, const ConvexSet& set) {
  thread_local Ring now, next;
  now.assign(ring.begin(), ring.end());
  for (const ConvexSet::Edge& edge : set.edges) {
    if (now.empty()) break;
    clip_by_line(now, edge.from, edge.to, next);
    now.swap(next);
  }
  return now;
}

}  // namespace

ConvexSet convex_set(const Ring& ring) {
  assert(signed_area(ring) > 0);
  ConvexSet set;
  set.box = bounds(ring);
  for (std::size_t i = 0; i < ring.size(); ++i) set.edges.push_back({ring[i], ring[(i + 1) % ring.size()]});
  return set;
}

ConvexSet common(const ConvexSet& a, const ConvexSet& b) {
  ConvexSet set;
  set.edges.reserve(a.edges.size() + b.edges.size());
  set.edges.insert(set.edges.end(), a.edges.begin(), a.edges.end());
  set.edges.insert(set.edges.end(), b.edges.begin(), b.edges.end());
  set.box = {std::max(a.box.min_x, b.box.min_x), std::max(a.box.min_y, b.box.min_y),
             std::min(a.box.max_x, b.box.max_x), std::min(a.box.max_y, b.box.max_y)};
  return set;
}

RingSet clipped(const RingSet& rings, const ConvexSet& set) {
  RingSet out;
  for (const Ring& ring : rings) {
    if (!intersects(bounds(ring), set.box)) continue;
    if (const Ring& part = clipped_by_set(ring, set); part.size() >= 3) out.push_back(part);
  }
  return out;
}

Ring convex_intersection(const Ring& a, const Ring& b) {
  if (!intersects(bounds(a), bounds(b))) return {};
  const Ring& out = clipped_by_set(a, convex_set(b));
  return out.size() >= 3 ? out : Ring{};
}

double signed_area(const RingSet& rings) {
  double sum = 0;
  for (const Ring& ring : rings) sum += signed_area(ring);
  return sum;
}

double area_in_union(const RingSet& rings, const std::vector<ConvexSet>& sets) {
  double sum = 0;
  for (std::size_t k = 0; k < sets.size(); ++k) {
    const RingSet inside = clipped(rings, sets[k]);
    if (inside.empty()) continue;
    sum += signed_area(inside);
    std::vector<ConvexSet> later;
    for (std::size_t j = k + 1; j < sets.size(); ++j)
      if (intersects(sets[j].box, sets[k].box)) later.push_back(common(sets[j], sets[k]));
    if (!later.empty()) sum -= area_in_union(inside, later);
  }
  return sum;
}

}  // namespace tramline
