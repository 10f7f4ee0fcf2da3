#pragma once
// Shapes drawn on the map, in the coordinates of a field's input.

#include <string>

#include "tramline/admission/read_obstacles.h"
#include "tramline/model/field.h"
#include "tramline/model/raw_feature.h"

namespace tramline::server {

/// The shape as a feature that is not yet cut to the field, of kind obstacle. A field in plain metres was
/// drawn on about (0°, 0°). Throws bad_input for a place too far off. O(vertices).
LooseObstacle drawn_shape(const RawFeature& shape, const std::string& origin, const Field& field);

}  // namespace tramline::server
