#pragma once
// A path moved sideways.

#include <optional>

#include "tramline/geometry/path/path.h"

namespace tramline {

/// The path `right_m` to the right (negative: to the left): lines moved, arcs with other radii, tangents as
/// continuous as before. nullopt where an arc would become tighter than `least_radius_m` (> 0). O(n).
std::optional<Path> shifted(const Path& path, double right_m, double least_radius_m);

}  // namespace tramline
