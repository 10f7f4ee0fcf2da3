#include "tramline/io/geopackage/local_crs.h"

#include <fmt/format.h>

#include "tramline/geometry/error.h"
#include "tramline/model/plain_zero.h"

namespace tramline::io {

OGRSpatialReference crs_of(const LocalFrame& frame) {
  OGRSpatialReference crs;
  bool made = false;
  if (frame.geodetic) {
    made =
        crs.SetProjCS("Local transverse Mercator of the field") == OGRERR_NONE &&
        crs.SetWellKnownGeogCS("WGS84") == OGRERR_NONE &&
        crs.SetTM(plain_zero(frame.origin_lat_deg), plain_zero(frame.origin_lon_deg), 1, 0, 0) == OGRERR_NONE;
  } else {
    made = crs.SetLocalCS("Undefined Cartesian SRS") == OGRERR_NONE &&
           crs.SetLinearUnits(SRS_UL_METER, 1) == OGRERR_NONE;
  }
  if (!made)
    throw failure(
        fmt::format("no coordinate reference system could be made for the local frame centred on {} {}",
                    frame.origin_lon_deg, frame.origin_lat_deg));
  crs.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
  return crs;
}

Point offset_of(const LocalFrame& frame) {
  return frame.geodetic ? Point{} : Point{frame.origin_x_m, frame.origin_y_m};
}

}  // namespace tramline::io
