#pragma once
// The coordinate reference system a plan's local metres are written in.

#include <ogr_spatialref.h>

#include "tramline/geometry/point.h"
#include "tramline/model/local_frame.h"

namespace tramline::io {

/// Geodetic frame: the local transverse Mercator on WGS 84. Plain frame: an engineering CRS in
/// metres, tied to no place on earth. Throws Error(kFailure) where PROJ refuses the definition.
OGRSpatialReference crs_of(const LocalFrame& frame);

/// What has to be added to local coordinates to get those of the CRS: the plain frame's origin, so
/// that the plan lies on the plane it came from; (0, 0) for a geodetic frame.
Point offset_of(const LocalFrame& frame);

}  // namespace tramline::io
