#pragma once
// Projects shapes of a plan file to another coordinate reference system.

#include <ogr_geometry.h>

#include <memory>

#include "tramline/io/export/target_crs.h"

namespace tramline::io {

/// The largest distance of an exported line from the plan's, m. A line that is straight in the field's plane
/// is not straight in degrees: 1 km east to west at 50° north is off by 2.5 cm in its middle.
inline constexpr double kMostAside_m = 0.01;

/// The shape in the target's coordinates, vertex for vertex; where an edge would run more than `most_aside_m`
/// beside the plan's, points are added to it at equal distances. `offset` is subtracted first (offset_of()).
/// Points, lines, polygons and multipolygons. Throws Error(kBadInput) where a point has no position in the
/// target. Precondition: most_aside_m > 0. O(n).
std::unique_ptr<OGRGeometry> projected(const OGRGeometry& shape, Point offset, const TargetCrs& target,
                                       double most_aside_m);

}  // namespace tramline::io
