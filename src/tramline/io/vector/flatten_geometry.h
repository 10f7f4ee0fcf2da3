#pragma once
// An OGR geometry as rings, lines and points.

#include "tramline/io/vector/layer_crs.h"
#include "tramline/model/raw_feature.h"

class OGRGeometry;

namespace tramline::io {

/// Adds the geometry to the feature: curves linearised, Z and M noted and dropped, collections flattened.
/// nullptr is "none".
void flatten_geometry(const OGRGeometry* geometry, AxisOrder axes, RawFeature& feature);

}  // namespace tramline::io
