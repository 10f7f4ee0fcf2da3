#pragma once
// The plane of AgOpenGPS: metres east and north of the point where a field was started.

#include "tramline/geometry/point.h"

namespace tramline::io {

/// Metres for degrees by series in the latitude: that of a degree of latitude at the start, that of a degree
/// of longitude at the point itself. Not a projection with true lengths: over 2 km it deviates by centimetres
/// from one, which cancel where the same series lead back.
class LocalPlane {
 public:
  /// Beyond it degrees of longitude are too short for a plane.
  static constexpr double kMostLatitude_deg = 85;

  /// `start`: longitude and latitude of (0, 0), degrees on WGS 84. Precondition: no nearer to a pole than
  /// kMostLatitude_deg.
  explicit LocalPlane(Point start_lonlat);

  Point to_plane(Point lonlat) const;
  /// Longitudes go on beyond 180° where the field lies across the date line, so that it is in one piece.
  Point to_lonlat(Point metres) const;

 private:
  Point start_;
  double latitude_degree_m_;
};

}  // namespace tramline::io
