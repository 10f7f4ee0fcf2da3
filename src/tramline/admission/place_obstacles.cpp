#include "tramline/admission/read_obstacles.h"

#include <fmt/format.h>

#include "tramline/admission/given/loose_land.h"
#include "tramline/admission/repair_log.h"
#include "tramline/admission/tolerances.h"
#include "tramline/admission/unite_obstacles.h"
#include "tramline/geometry/polygon/boolean.h"

namespace tramline {
namespace {

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
  const std::vector<std::size_t> candidates = features_near(field, size_m, obstacles);
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
