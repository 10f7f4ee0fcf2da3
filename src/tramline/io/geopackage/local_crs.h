#pragma once
// The coordinate reference system in which a plan's local metres are written.

#include <ogr_spatialref.h>

#include "tramline/geometry/point.h"
#include "tramline/model/local_frame.h"

namespace tramline::io {

/// Geodetic frame: the local transverse Mercator on WGS 84. Plain frame: an engineering CRS in
/// metres, without a position on earth. Throws Error(kFailure) where PROJ refuses the definition.
OGRSpatialReference crs_of(const LocalFrame& frame);

/// The offset to add to local coordinates to get those of the CRS: the plain frame's origin, so that the plan
/// lies in the plane it came from; (0, 0) for a geodetic frame.
Point offset_of(const LocalFrame& frame);

}  // namespace tramline::io
