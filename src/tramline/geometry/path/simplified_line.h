#pragma once
// The vertices that carry a polyline's shape.

#include <cstddef>
#include <vector>

#include "tramline/geometry/point.h"

namespace tramline {

/// Indices, in increasing order, of vertices such that the line through them keeps within `tolerance_m` of
/// all the others (Douglas and Peucker 1973); the first and the last are kept, and none within 1 µm of the
/// vertex kept before it. O(n²) at worst, mostly O(n log n).
std::vector<std::size_t> simplified_line(const std::vector<Point>& line, double tolerance_m);

}  // namespace tramline
