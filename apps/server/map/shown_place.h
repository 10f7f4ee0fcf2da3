#pragma once
// Converts a field's local metres to the map of the page, and back.

#include <nlohmann/json.hpp>
#include <vector>

#include "tramline/geodesy/field_projection.h"
#include "tramline/geometry/path/path.h"
#include "tramline/geometry/polygon/region.h"
#include "tramline/model/local_frame.h"

namespace tramline::server {

/// Longitude and latitude of a frame; a plain one is shown about (0°, 0°), as io::layer_geojson() has it. One
/// object on one thread at a time.
class ShownPlace {
 public:
  explicit ShownPlace(const LocalFrame& frame);

  Point to_lonlat(Point local_m) const { return projection_.to_lonlat(local_m); }
  /// Throws bad_input for a place too far off.
  Point to_local(Point lonlat) const;

  /// GeoJSON coordinates.
  nlohmann::ordered_json position(Point local_m) const;
  nlohmann::ordered_json line(const std::vector<Point>& points) const;
  nlohmann::ordered_json polygon(const Polygon& polygon) const;
  nlohmann::ordered_json region(const Region& region) const;
  /// [west, south, east, north]
  nlohmann::ordered_json bbox(const Box& box) const;

 private:
  FrameProjection projection_;
};

/// One feature.
nlohmann::ordered_json feature_json(const char* type, nlohmann::ordered_json coordinates,
                                    nlohmann::ordered_json properties);
nlohmann::ordered_json collection_json(nlohmann::ordered_json features);

}  // namespace tramline::server
