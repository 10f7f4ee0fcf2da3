#pragma once
// Obstacle features from other files, checked once and converted to longitude and latitude.

#include <string>
#include <vector>

#include "tramline/geodesy/crs.h"
#include "tramline/geometry/polygon/region.h"
#include "tramline/model/field.h"
#include "tramline/model/raw_feature.h"

namespace tramline {

/// One obstacle feature. Coordinates: WGS 84 longitude and latitude, or plain metres like the fields'.
struct LooseObstacle {
  std::string origin;  ///< "pylons.geojson feature 12"
  ObstacleKind kind = ObstacleKind::kObstacle;
  std::vector<RawPolygon> polygons;
  std::vector<std::vector<Point>> lines;
  std::vector<Point> points;
  Box bounds;
};

/// The obstacles of a dataset. A layer without a CRS is read in `fields_crs`, a definition as accepted by
/// Crs. Where the fields are in plain metres coordinates are kept as they are, and a layer in degrees is
/// refused. Throws bad_input naming file, feature and vertex for coordinates that are not finite or not on
/// the
/// globe, and for features without geometry: an obstacle is never dropped. O(vertices).
std::vector<LooseObstacle> read_obstacles(const RawDataset& dataset, ObstacleKind kind,
                                          const std::string& fields_crs);

}  // namespace tramline
