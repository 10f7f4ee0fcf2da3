#include "tramline/decomposition/events.h"

#include <numbers>

namespace tramline {
namespace {

void append_events(const Ring& ring, Angle threshold, double short_edge_m, std::vector<SplitEvent>& out) {
  const std::size_t n = ring.size();
  for (std::size_t i = 0; i < n; ++i) {
    const SplitEvent corner{ring[(i + n - 1) % n], ring[i], ring[(i + 1) % n]};
    const bool minute = distance(corner.previous, corner.vertex) < short_edge_m &&
                        distance(corner.vertex, corner.next) < short_edge_m;
    if (!minute && interior_angle(corner.previous, corner.vertex, corner.next) > threshold)
      out.push_back(corner);
  }
}

}  // namespace

Angle interior_angle(Point previous, Point vertex, Point next) {
  const Point in = vertex - previous, out = next - vertex;
  return Angle::radians(std::numbers::pi - std::atan2(cross(in, out), dot(in, out)));
}

std::vector<SplitEvent> split_events(const Polygon& polygon, Angle threshold, double short_edge_m) {
  std::vector<SplitEvent> events;
  append_events(polygon.outer, threshold, short_edge_m, events);
  for (const Ring& hole : polygon.holes) append_events(hole, threshold, short_edge_m, events);
  return events;
}

}  // namespace tramline
