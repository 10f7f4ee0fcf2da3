#include "tramline/io/mission/geofence.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

namespace tramline::io {
namespace {

/// How far a point may be on the wrong side of a fence, m: less than receivers resolve.
constexpr double kBeside_m = 0.02;

double distance_to_ring(const Ring& ring, Point p) {
  double out = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < ring.size(); ++i)
    out = std::min(out, distance_to_segment(p, ring[i], ring[(i + 1) % ring.size()]));
  return out;
}

}  // namespace

Geofence geofence_of(const Plan& plan, const std::vector<WayPoint>& route) {
  Geofence out;
  const Ring& outer = plan.field.outer;
  const bool stays = std::all_of(route.begin(), route.end(), [&](const WayPoint& point) {
    return contains(outer, point.at) || distance_to_ring(outer, point.at) <= kBeside_m;
  });
  if (stays)
    out.stay_inside.push_back(outer);
  else
    out.notes.emplace_back("the route leaves the field, so its boundary is no fence");
  for (std::size_t i = 0; i < plan.field.obstacles.size(); ++i) {
    const Obstacle& obstacle = plan.field.obstacles[i];
    if (obstacle.kind == ObstacleKind::kPassable) continue;
    const Ring& ring = obstacle.shape.outer;
    const bool met = std::any_of(route.begin(), route.end(), [&](const WayPoint& point) {
      return contains(ring, point.at) && distance_to_ring(ring, point.at) > kBeside_m;
    });
    if (met)
      out.notes.push_back(fmt::format("the route leads over obstacle {}, so it is no fence", i + 1));
    else
      out.stay_outside.push_back(ring);
  }
  return out;
}

}  // namespace tramline::io
