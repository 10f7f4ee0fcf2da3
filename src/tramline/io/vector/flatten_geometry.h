#pragma once
// An OGR geometry as rings, lines and points.

#include "tramline/model/raw_feature.h"

class OGRGeometry;

namespace tramline::io {

/// Adds the geometry to the feature: curves linearised, Z and M noted and dropped, collections flattened.
/// With `swap_axes` the first coordinate is taken as y. nullptr is "none".
void flatten_geometry(const OGRGeometry* geometry, bool swap_axes, RawFeature& feature);

}  // namespace tramline::io
