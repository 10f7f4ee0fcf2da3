#pragma once
// Polygons with their boxes, so that most of them are skipped without reading their vertices.

#include <vector>

#include "tramline/check/measure/piece_frame.h"
#include "tramline/geometry/polygon/region.h"
#include "tramline/model/field.h"

namespace tramline::check {

struct BoundedPolygon {
  const Polygon* shape;
  Box box;
};
using BoundedRegion = std::vector<BoundedPolygon>;

/// Refers to the shapes of the field, which has to outlive the result.
BoundedRegion bounded_obstacles(const Field& field, ObstacleKind kind);
/// Refers to the polygons of the region.
BoundedRegion bounded(const Region& region);

/// The sum of the areas, m², that each polygon of some land has in common with each polygon of the region.
double area_common_to(const Region& ground, const BoundedRegion& region);

/// The parts of all polygons within a rectangle of the piece's frame; `at` lies on the largest part.
Clipped clipped(const BoundedRegion& region, const PieceFrame& frame, const Box& rectangle);

}  // namespace tramline::check
