#pragma once
// The edges of a part of the land beyond which an obstacle lies.

#include <vector>

#include "tramline/geometry/polygon/region.h"

namespace tramline {

/// For each edge of the outline, ring after ring, the edge to a ring's first corner first: whether it lies on
/// the boundary of one of the obstacles, which the outline does not overlap. O(n·m) for n edges of the
/// outline and m of obstacles, but only where their boxes meet.
std::vector<bool> edges_at_obstacles(const std::vector<Ring>& outline, const Region& obstacles);

}  // namespace tramline
