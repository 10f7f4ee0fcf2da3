#include "tramline/admission/given/loose_land.h"

#include <fmt/format.h>

#include <optional>

#include "tramline/admission/project_rings.h"
#include "tramline/admission/remove_duplicate_points.h"
#include "tramline/admission/remove_spikes.h"
#include "tramline/admission/repair_crossings.h"
#include "tramline/admission/tolerances.h"
#include "tramline/geometry/polygon/boolean.h"

namespace tramline {
namespace {

/// The land a ring of an obstacle encloses; empty for rings without area.
Region enclosed_by(const RawRing& raw, const std::string& name, RepairLog& repair_log) {
  WorkRing ring = project_ring(raw, name, repair_log);
  remove_duplicate_points(ring, repair_log);
  remove_spikes(ring, repair_log);
  if (ring.points.size() < 3 || area(made_valid({ring.points, {}})) <= kNoArea_m2) return {};
  return repair_crossings(ring, RingRole::kHole, repair_log);
}

void append(Region& to, Region more) {
  for (Polygon& polygon : more) to.push_back(std::move(polygon));
}

Region polygon_land(const RawPolygon& polygon, const std::string& origin, RepairLog& repair_log) {
  Region land;
  for (std::size_t r = 0; r < polygon.rings.size(); ++r) {
    const Region ring =
        enclosed_by(polygon.rings[r], fmt::format("{}, {}", origin, ring_name(r)), repair_log);
    if (r == 0)
      land = ring;
    else if (!ring.empty())
      land = difference(land, ring);
  }
  return land;
}

Region line_land(const std::vector<Point>& line, double size_m, RepairLog& repair_log) {
  WorkRing track = project_ring({line, true}, "line", repair_log);
  std::vector<Point> points;
  for (const Point p : track.points)
    if (points.empty() || distance(points.back(), p) > kSamePlace_m) points.push_back(p);
  if (points.size() < 2) return {};
  return buffered_line(points, 0.5 * size_m);
}

Region point_land(Point p, double size_m) {
  const double h = 0.5 * size_m;
  return {{{{p.x - h, p.y - h}, {p.x + h, p.y - h}, {p.x + h, p.y + h}, {p.x - h, p.y + h}}, {}}};
}

/// The field's box in the obstacles' coordinates, grown by `margin_m`.
Box reach_of_field(const Field& field, double margin_m) {
  const Box local = bounds(field.outer).grown(margin_m);
  std::optional<FrameProjection> projection;
  if (field.frame.geodetic) projection.emplace(field.frame);
  Box out;
  // The edges of the box bulge a little in longitude and latitude, so its middle points count too.
  for (const double x : {local.min_x, local.centre().x, local.max_x})
    for (const double y : {local.min_y, local.centre().y, local.max_y})
      out.extend(projection ? projection->to_lonlat({x, y})
                            : Point{x + field.frame.origin_x_m, y + field.frame.origin_y_m});
  return out;
}

}  // namespace

Region land_of(const LooseObstacle& feature, double size_m, RepairLog& repair_log) {
  Region land;
  for (const RawPolygon& polygon : feature.polygons)
    append(land, polygon_land(polygon, feature.origin, repair_log));
  for (const auto& line : feature.lines) append(land, line_land(line, size_m, repair_log));
  for (const Point p : feature.points) {
    const auto local = repair_log.projection().to_local(p);
    if (local) append(land, point_land(*local, size_m));
  }
  return land.size() > 1 ? unite(land) : land;
}

std::vector<std::size_t> features_near(const Field& field, double margin_m,
                                       const std::vector<LooseObstacle>& features) {
  const Box reach = reach_of_field(field, margin_m);
  std::vector<std::size_t> out;
  for (std::size_t i = 0; i < features.size(); ++i)
    if (intersects(reach, features[i].bounds)) out.push_back(i);
  return out;
}

}  // namespace tramline
