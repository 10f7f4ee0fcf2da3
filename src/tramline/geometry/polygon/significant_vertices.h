#pragma once
// The vertices that carry a ring's shape.

#include <cstddef>
#include <vector>

#include "tramline/geometry/polygon/region.h"

namespace tramline {

/// Indices, in increasing order, of vertices such that the ring through them keeps within `tolerance_m`
/// of all the others (Douglas and Peucker 1973, from the two vertices farthest apart along the diagonal of
/// the bounding box). Only two where the ring is nowhere wider than the tolerance. O(n²) at worst, mostly
/// O(n log n).
std::vector<std::size_t> significant_vertices(const Ring& ring, double tolerance_m);

/// The polygon through the significant vertices of its rings; the polygon itself where that one is not valid.
Polygon simplified(const Polygon& polygon, double tolerance_m);

}  // namespace tramline
