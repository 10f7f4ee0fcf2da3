#include "tramline/decomposition/cuts.h"

#include <algorithm>
#include <limits>
#include <optional>

namespace tramline {
namespace {

/// Whether a ray from the corner in direction `ray` starts into the field: strictly between the two
/// edges, on the left of the ring. Rays within kAlongEdge of an edge follow that edge.
bool points_inside(const SplitEvent& corner, Point ray) {
  constexpr double kAlongEdge = 1e-9;
  const Point to_next = corner.next - corner.vertex, to_previous = corner.previous - corner.vertex;
  const auto turn_from_next = [&to_next](Point v) {
    const double angle = std::atan2(cross(to_next, v), dot(to_next, v));
    return angle < 0 ? angle + 2 * std::numbers::pi : angle;
  };
  const double opening = turn_from_next(to_previous);
  const double turn = turn_from_next(ray);
  return turn > kAlongEdge && turn < opening - kAlongEdge;
}

/// Distance along the vertical from `start` to the nearest boundary above (sense +1) or below (−1).
std::optional<double> nearest_boundary(const std::vector<Ring>& turned, Point start, int sense) {
  constexpr double kSamePoint = 1e-9;
  double nearest = std::numeric_limits<double>::infinity();
  for (const Ring& ring : turned)
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const Point a = ring[i], b = ring[(i + 1) % ring.size()];
      if (std::min(a.x, b.x) > start.x || std::max(a.x, b.x) < start.x) continue;
      const double low = std::min(a.y, b.y), high = std::max(a.y, b.y);
      const double y = a.x == b.x ? (sense > 0 ? low : high)
                                  : std::clamp(a.y + (b.y - a.y) * ((start.x - a.x) / (b.x - a.x)), low, high);
      const double distance = sense * (y - start.y);
      if (distance > kSamePoint) nearest = std::min(nearest, distance);
    }
  if (nearest == std::numeric_limits<double>::infinity()) return std::nullopt;
  return nearest;
}

}  // namespace

std::vector<std::vector<Point>> cut_lines(const Polygon& polygon, const std::vector<SplitEvent>& events,
                                          Direction direction) {
  const TrackFrame frame(direction);
  std::vector<Ring> turned{frame.to_track(polygon.outer)};
  for (const Ring& hole : polygon.holes) turned.push_back(frame.to_track(hole));
  std::vector<std::vector<Point>> cuts;
  for (const SplitEvent& event : events) {
    const Point start = frame.to_track(event.vertex);
    for (const int sense : {+1, -1}) {
      const Point ray = static_cast<double>(sense) * direction.unit();
      if (!points_inside(event, ray)) continue;
      if (const auto reach = nearest_boundary(turned, start, sense))
        cuts.push_back({event.vertex, event.vertex + (*reach + kCutOvershoot) * ray});
    }
  }
  return cuts;
}

}  // namespace tramline
