#pragma once
// Obstacle features from other files: checked once and converted to longitude and latitude, then added to
// fields.

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

/// Adds the obstacles that intersect the field to field.obstacles: lines widened to `size_m` with flat ends,
/// points as axis-parallel squares of `size_m`, everything cut to the outer ring, overlapping ones united,
/// and passable land less the land of real obstacles. `used` (one flag per obstacle) is set for those used;
/// the others lie elsewhere. Repairs of the obstacles' own rings go to field.repairs (with positions in
/// longitude and latitude, or plain metres). Throws bad_input when obstacles cover the whole field.
/// O(obstacles) box tests, and O(n log n) per obstacle used.
void place_obstacles(Field& field, const std::vector<LooseObstacle>& obstacles, double size_m,
                     std::vector<char>& used);

}  // namespace tramline
