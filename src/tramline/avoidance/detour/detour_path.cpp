#include "tramline/avoidance/detour/detour_path.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

#include "tramline/avoidance/detour/detour_hull.h"

namespace tramline {
namespace {

/// Sets the centre and the end of an arc to the straight track.
void set_arc(double along, double arc, Approach& approach) {
  approach.arc_centre = {along, arc};
  approach.on_track = {along, 0};
}

/// The approach where a disc of radius `arc` that rolls on the track from the right first touches the hull.
Approach first_touch(const Hull& hull, double arc) {
  const double reach = arc + hull.radius;
  Approach out;
  double farthest = -std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < hull.centres.size(); ++i) {
    const Point v = hull.centres[i];
    const double rise = arc - v.y;
    if (std::abs(rise) <= reach) {
      const double along = v.x + std::sqrt((reach - rise) * (reach + rise));
      if (along > farthest) {
        farthest = along;
        out.vertex = i;
        out.normal = (1 / reach) * (Point{along, arc} - v);
      }
    }
    if (i + 1 == hull.centres.size()) break;
    // The edge to the next vertex, whose normal points up.
    const Point edge = hull.centres[i + 1] - v;
    const Point normal = (1 / length(edge)) * Point{-edge.y, edge.x};
    if (edge.y >= 0) continue;  // a rising edge faces the other way
    const double along = v.x + (reach - normal.y * rise) / normal.x;
    const double foot = dot(Point{along, arc} - v, edge);
    if (foot > 0 && foot < dot(edge, edge) && along > farthest) {
      farthest = along;
      out.vertex = i;
      out.normal = normal;
    }
  }
  set_arc(farthest, arc, out);
  return out;
}

/// The approach by a descending line of the steepest slope that touches the hull.
Approach down_a_line(const Hull& hull, double arc) {
  const SteepLine line = steepest_line(hull);
  Approach out = line.touching;
  set_arc((line.off_m + arc - out.normal.y * arc) / out.normal.x, arc, out);
  return out;
}

/// nullopt where the hull does not reach over the track.
std::optional<Approach> approach_to(const Hull& hull, double arc) {
  Approach out = first_touch(hull, arc);
  const bool below =
      std::all_of(hull.centres.begin(), hull.centres.end(), [&](Point v) { return v.y + hull.radius <= 0; });
  if (below) return std::nullopt;
  const double drop = out.normal.y;  // cosine of the heading against the track
  if (!std::isfinite(out.arc_centre.x) || drop < 0 || hull.centres.back().y > arc)
    return down_a_line(hull, arc);
  return out;
}

std::optional<Path> path_round(const Hull& hull, double arc) {
  const std::optional<Approach> out = approach_to(hull, arc);
  const Hull other_way = mirrored(hull);
  const std::optional<Approach> in = approach_to(other_way, arc);
  if (!out || !in) return std::nullopt;
  const Approach there = mirrored(*in, hull);
  if (there.vertex > out->vertex) return std::nullopt;
  return hull_path(hull, there, *out, arc);
}

}  // namespace

std::optional<Path> detour_path(const std::vector<KeepOut>& discs, double radius_m, HullCorners corners) {
  assert(!discs.empty());
  assert(radius_m > 0);
  return path_round(hull_round(discs, radius_m, corners), radius_m);
}

}  // namespace tramline
