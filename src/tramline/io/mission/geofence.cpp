#include "tramline/io/mission/geofence.h"

#include <fmt/format.h>

#include <algorithm>

#include "tramline/geometry/polygon/boolean.h"

namespace tramline::io {
namespace {

/// How far a route may be on the wrong side of a fence, m: less than receivers resolve.
constexpr double kBeside_m = 0.02;
/// A shorter stretch within a region is none, m: rounding.
constexpr double kNoStretch_m = 1e-6;

/// Whether `of_stretch` holds for any straight stretch from one point of the route to the next.
template <class OfStretch>
bool any_stretch(const std::vector<WayPoint>& route, const OfStretch& of_stretch) {
  for (std::size_t i = 0; i + 1 < route.size(); ++i)
    if (route[i].at != route[i + 1].at && of_stretch(route[i].at, route[i + 1].at)) return true;
  return false;
}

bool leaves(const std::vector<WayPoint>& route, const Ring& ring) {
  const Region land = buffered({{ring, {}}}, kBeside_m);
  return any_stretch(
      route, [&](Point a, Point b) { return length_inside(land, a, b) < distance(a, b) - kNoStretch_m; });
}

bool enters(const std::vector<WayPoint>& route, const Ring& ring) {
  const Region core = buffered({{ring, {}}}, -kBeside_m);
  if (core.empty()) return false;
  const Box reach = bounds(core);
  return any_stretch(route, [&](Point a, Point b) {
    return intersects(bounds(Ring{a, b}), reach) && length_inside(core, a, b) > kNoStretch_m;
  });
}

}  // namespace

Geofence geofence_of(const Plan& plan, const std::vector<WayPoint>& route) {
  Geofence out;
  const Ring& outer = plan.field.outer;
  if (leaves(route, outer))
    out.notes.emplace_back("the route leaves the field, so its boundary is no fence");
  else
    out.stay_inside.push_back(outer);
  for (std::size_t i = 0; i < plan.field.obstacles.size(); ++i) {
    const Obstacle& obstacle = plan.field.obstacles[i];
    if (obstacle.kind == ObstacleKind::kPassable) continue;
    const Ring& ring = obstacle.shape.outer;
    if (enters(route, ring))
      out.notes.push_back(fmt::format("the route leads over obstacle {}, so it is no fence", i + 1));
    else
      out.stay_outside.push_back(ring);
  }
  return out;
}

}  // namespace tramline::io
