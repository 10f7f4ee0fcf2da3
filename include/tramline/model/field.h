#pragma once
// A field as admitted, fit to be planned.

#include <string>
#include <vector>

#include "tramline/geometry/polygon/region.h"
#include "tramline/model/local_frame.h"
#include "tramline/model/report.h"

namespace tramline {

enum class ObstacleKind {
  kObstacle,  ///< the machine may not enter
  kPassable,  ///< crossed with the work interrupted (a grassed waterway)
};

struct Obstacle {
  Polygon shape;  ///< local frame, oriented, inside the field's outer ring (clipped to it if need be)
  ObstacleKind kind = ObstacleKind::kObstacle;
  std::string origin;  ///< where in the input it comes from: "hole 3", "pylons.geojson feature 12"
};

/// The origin of a field in the user's files.
struct FieldSource {
  std::string file;
  std::string layer;
  long long fid = -1;
  int part = 0;                  ///< 0-based part of a multipolygon
  std::string crs{};             ///< as the user gave it; empty: the file's own
  std::string input_crs{};       ///< CRS the coordinates were read in, as Crs::definition(); empty: unknown
  std::string obstacles_file{};  ///< further obstacles; empty: none
  double obstacle_size_m = 0;    ///< size given to points and lines in obstacles_file
  std::string passable_file{};
};

/// Frame: local metres. outer is simple and counter-clockwise; obstacles do not overlap one another.
struct Field {
  std::string id;  ///< the feature's id property, or layer:fid; "#2" is added for further parts
  Ring outer;
  std::vector<Obstacle> obstacles;
  LocalFrame frame;
  FieldSource source;
  std::vector<Repair> repairs;
  std::vector<std::string> warnings;
};

/// Area within the outer ring less the obstacles; passable ones count as field. m²
double area_m2(const Field& field);

}  // namespace tramline
