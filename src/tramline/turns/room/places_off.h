#pragma once
// Where a turning machine leaves the land.

#include <vector>

#include "tramline/turns/outline/outline.h"
#include "tramline/turns/room/land_edges.h"

namespace tramline {

/// Points of the outline that are off the land, at places `step_m` apart on the path and on the sides of the
/// outline. To tell which edges are in the way, not whether there is room: that is AllowedLand::fits().
/// Preconditions: step_m > 0; no reverse where the outline tows. O(places · edges beside them).
std::vector<Point> places_off(const LandEdges& land, const SteeredPath& path, const Outline& outline,
                              double step_m);

}  // namespace tramline
