#include "tramline/check/measure/bounded_polygon.h"

#include "tramline/geometry/polygon/boolean.h"

namespace tramline::check {

BoundedRegion bounded_obstacles(const Field& field, ObstacleKind kind) {
  BoundedRegion out;
  for (const Obstacle& obstacle : field.obstacles)
    if (obstacle.kind == kind) out.push_back({&obstacle.shape, bounds(obstacle.shape)});
  return out;
}

BoundedRegion bounded(const Region& region) {
  BoundedRegion out;
  for (const Polygon& polygon : region) out.push_back({&polygon, bounds(polygon)});
  return out;
}

double area_common_to(const Region& ground, const BoundedRegion& region) {
  double sum = 0;
  for (const Polygon& part : ground) {
    const Box box = bounds(part);
    for (const BoundedPolygon& polygon : region)
      if (intersects(polygon.box, box)) sum += area(intersection({part}, {*polygon.shape}));
  }
  return sum;
}

Clipped clipped(const BoundedRegion& region, const PieceFrame& frame, const Box& rectangle) {
  Clipped out;
  if (region.empty()) return out;
  const Box near = frame.field_box(rectangle);
  double largest = 0;
  for (const BoundedPolygon& polygon : region) {
    if (!intersects(polygon.box, near)) continue;
    const Clipped part = clipped(*polygon.shape, frame, rectangle);
    out.area_m2 += part.area_m2;
    if (part.area_m2 <= largest) continue;
    largest = part.area_m2;
    out.at = part.at;
  }
  return out;
}

}  // namespace tramline::check
