#pragma once
// Where a machine leaves the land, by a road of its own: every 5 cm, point by point.

#include "tramline/geometry/path/steered_path.h"
#include "tramline/model/field.h"

namespace tramline::testing {

/// How far a bar of this width at the axle leaves the field, or gets into its obstacles, on the path, m.
double off_the_land_m(const Field& field, double width_m, const SteeredPath& path);

}  // namespace tramline::testing
