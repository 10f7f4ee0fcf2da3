#include "tramline/model/field.h"

namespace tramline {

double area_m2(const Field& field) {
  double sum = area(Polygon{field.outer, {}});
  for (const Obstacle& obstacle : field.obstacles)
    if (obstacle.kind == ObstacleKind::kObstacle) sum -= area(obstacle.shape);
  return sum;
}

}  // namespace tramline
