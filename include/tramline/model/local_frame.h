#pragma once
// The plane in which a field is planned.

namespace tramline {

/// Either a transverse Mercator (WGS 84, scale 1) centred on the field, or, for input that is plain
/// metres already, a shift of the input plane. Local coordinates are metres, x east, y north.
struct LocalFrame {
  bool geodetic = false;
  double origin_lon_deg = 0;  ///< geodetic: centre of the projection
  double origin_lat_deg = 0;
  double origin_x_m = 0;  ///< plain: local (0, 0) in the input plane
  double origin_y_m = 0;

  friend bool operator==(const LocalFrame& a, const LocalFrame& b) = default;
};

}  // namespace tramline
