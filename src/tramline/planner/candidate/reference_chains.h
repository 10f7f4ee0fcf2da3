#pragma once
// Chains of boundary edges that tracks might follow.

#include <vector>

#include "tramline/geometry/polygon/region.h"

namespace tramline {

/// Chains of edges of the outer rings between two corners, open polylines that bend somewhere by more than
/// `least_bend_m` from a straight line; the longest first, `most` at most. A corner is where the boundary
/// turns by more than 30° within `corner_m` of its length. A ring without two corners is one chain, from the
/// middle of its longest edge all the way round except for the last kSeam_m. O(n²).
std::vector<std::vector<Point>> reference_chains(const Region& ground, double corner_m, double least_bend_m,
                                                 std::size_t most);

}  // namespace tramline
