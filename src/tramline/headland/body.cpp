#include "tramline/headland/body.h"

#include "tramline/geometry/polygon/boolean.h"

namespace tramline {

Region obstacle_shapes(const Field& field, ObstacleKind kind) {
  Region out;
  for (const Obstacle& obstacle : field.obstacles)
    if (obstacle.kind == kind) out.push_back(obstacle.shape);
  return out;
}

Region body_of(const Field& field) {
  Region taken_out;
  for (const Obstacle& obstacle : field.obstacles) taken_out.push_back(obstacle.shape);
  return difference({{field.outer, {}}}, unite(taken_out));
}

}  // namespace tramline
