#pragma once
// The coordinate reference system that a layer declares.

#include <string>

class OGRSpatialReference;

namespace tramline::io {

/// WKT of the layer's CRS; empty for none and for the "undefined" ones GeoPackage prescribes. Throws
/// bad_input, naming the place, for local grids that are not in metres.
std::string layer_crs(const OGRSpatialReference* srs, const std::string& place);

/// The order of a geometry's coordinates.
enum class AxisOrder {
  kXFirst,  ///< longitude or easting
  kYFirst,
};

/// The order used by OGR: longitude first whatever the authority says, unless a driver maps the axes
/// otherwise.
AxisOrder axis_order(const OGRSpatialReference* srs);

}  // namespace tramline::io
