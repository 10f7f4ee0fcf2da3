#include "tramline/admission/place_obstacles.h"

#include <fmt/format.h>

#include "tramline/admission/project_rings.h"
#include "tramline/admission/remove_duplicate_points.h"
#include "tramline/admission/remove_spikes.h"
#include "tramline/admission/repair_crossings.h"
#include "tramline/admission/repair_log.h"
#include "tramline/admission/tolerances.h"
#include "tramline/admission/unite_obstacles.h"
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

Region land_of(const LooseObstacle& obstacle, double size_m, RepairLog& repair_log) {
  Region land;
  for (const RawPolygon& polygon : obstacle.polygons)
    append(land, polygon_land(polygon, obstacle.origin, repair_log));
  for (const auto& line : obstacle.lines) append(land, line_land(line, size_m, repair_log));
  for (const Point p : obstacle.points) {
    const auto local = repair_log.projection().to_local(p);
    if (local) append(land, point_land(*local, size_m));
  }
  return land.size() > 1 ? unite(land) : land;
}

/// The field's box in the obstacles' coordinates, grown by `margin_m`.
Box reach(const Field& field, double margin_m) {
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

std::vector<std::size_t> near(const Box& reach, const std::vector<LooseObstacle>& obstacles) {
  std::vector<std::size_t> out;
  for (std::size_t i = 0; i < obstacles.size(); ++i)
    if (intersects(reach, obstacles[i].bounds)) out.push_back(i);
  return out;
}

void refuse_covered(const Field& field) {
  Region left = {{field.outer, {}}};
  for (const Obstacle& obstacle : field.obstacles)
    if (obstacle.kind == ObstacleKind::kObstacle) left = difference(left, {obstacle.shape});
  if (area(left) <= kNoArea_m2)
    throw bad_input(
        fmt::format("{}, feature '{}': the obstacles cover the whole field; check the obstacle file",
                    field.source.file, field.id));
}

/// Passable land is what no real obstacle stands on.
std::vector<Obstacle> less_obstacles(const std::vector<Obstacle>& passable,
                                     const std::vector<Obstacle>& real) {
  std::vector<Obstacle> out;
  for (const Obstacle& candidate : passable) {
    Region land = {candidate.shape};
    for (const Obstacle& obstacle : real)
      if (intersects(bounds(land), bounds(obstacle.shape)) &&
          area(intersection(land, {obstacle.shape})) > kNoArea_m2)
        land = difference(land, {obstacle.shape});
    for (Polygon& piece : land)
      if (area(piece) > kNoArea_m2) out.push_back({std::move(piece), candidate.kind, candidate.origin});
  }
  return out;
}

}  // namespace

void place_obstacles(Field& field, const std::vector<LooseObstacle>& obstacles, double size_m,
                     std::vector<char>& used) {
  const std::vector<std::size_t> candidates = near(reach(field, size_m), obstacles);
  if (candidates.empty()) return;
  const Crs crs = field.frame.geodetic ? Crs("OGC:CRS84") : Crs();
  const FieldProjection projection(crs, field.frame);
  std::vector<Obstacle> real, passable;
  for (Obstacle& obstacle : field.obstacles)
    (obstacle.kind == ObstacleKind::kPassable ? passable : real).push_back(std::move(obstacle));
  for (const std::size_t i : candidates) {
    RepairLog repair_log(obstacles[i].origin, projection);
    const Region inside = intersection(land_of(obstacles[i], size_m, repair_log), {{field.outer, {}}});
    if (area(inside) <= kNoArea_m2) continue;
    used[i] = 1;
    field.repairs.insert(field.repairs.end(), repair_log.repairs().begin(), repair_log.repairs().end());
    for (const Polygon& piece : inside)
      if (area(piece) > kNoArea_m2)
        (obstacles[i].kind == ObstacleKind::kPassable ? passable : real)
            .push_back({piece, obstacles[i].kind, obstacles[i].origin});
  }
  real = unite_obstacles(std::move(real), nullptr);
  passable = less_obstacles(unite_obstacles(std::move(passable), nullptr), real);
  field.obstacles = std::move(real);
  field.obstacles.insert(field.obstacles.end(), passable.begin(), passable.end());
  refuse_covered(field);
}

}  // namespace tramline
