#include "tramline/admission/lines/point_placer.h"

#include <fmt/format.h>

#include "tramline/geometry/error.h"

namespace tramline {

PointPlacer::PointPlacer(const Field& field, const PointSource& source)
    : field_(field), origin_(source.origin) {
  if (source.plain == field.frame.geodetic)
    throw bad_input(fmt::format("{}: the {} and field '{}' are not in the same coordinates; give --crs",
                                origin_, source.what, field.id));
  if (field.frame.geodetic) projection_.emplace(field.frame);
}

std::optional<Point> PointPlacer::try_place(Point p) const {
  if (!projection_) return p - Point{field_.frame.origin_x_m, field_.frame.origin_y_m};
  return projection_->from_lonlat(p);
}

Point PointPlacer::place(Point p) const {
  const std::optional<Point> local = try_place(p);
  if (!local)
    throw bad_input(
        fmt::format("{}: ({:.7f}, {:.7f}) lies too far from field '{}'", origin_, p.x, p.y, field_.id));
  return *local;
}

}  // namespace tramline
