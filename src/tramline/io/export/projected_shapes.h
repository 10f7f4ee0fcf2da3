#pragma once
// Shapes of a plan file put into another coordinate reference system.

#include <ogr_geometry.h>

#include <memory>

#include "tramline/io/export/target_crs.h"

namespace tramline::io {

/// How far a line may run beside the plan's at most. What is straight in the field's plane is not in degrees:
/// 1 km east to west at 50° north is off by 2.5 cm in its middle.
inline constexpr double kMostAside_m = 0.01;

/// The shape in the target's coordinates, vertex for vertex; where an edge would run more than `most_aside_m`
/// beside the plan's, points are added to it at equal distances. `offset` is taken off first (offset_of()).
/// Points, lines, polygons and multipolygons. Throws Error(kBadInput) where the target has no such place.
/// Precondition: most_aside_m > 0. O(n).
std::unique_ptr<OGRGeometry> projected(const OGRGeometry& shape, Point offset, const TargetCrs& target,
                                       double most_aside_m);

}  // namespace tramline::io
