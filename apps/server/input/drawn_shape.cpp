#include "server/input/drawn_shape.h"

#include <algorithm>

#include "server/map/shown_place.h"

namespace tramline::server {

LooseObstacle drawn_shape(const RawFeature& shape, const std::string& origin, const Field& field) {
  LooseObstacle out{origin, ObstacleKind::kObstacle, shape.polygons, shape.lines, shape.points, {}};
  const ShownPlace place(field.frame);
  const Point corner{field.frame.origin_x_m, field.frame.origin_y_m};
  const auto bring = [&](Point& p) {
    const Point local = place.to_local(p);
    if (!field.frame.geodetic) p = local + corner;
    out.bounds.extend(p);
  };
  for (RawPolygon& polygon : out.polygons)
    for (RawRing& ring : polygon.rings) std::for_each(ring.points.begin(), ring.points.end(), bring);
  for (std::vector<Point>& line : out.lines) std::for_each(line.begin(), line.end(), bring);
  std::for_each(out.points.begin(), out.points.end(), bring);
  return out;
}

}  // namespace tramline::server
