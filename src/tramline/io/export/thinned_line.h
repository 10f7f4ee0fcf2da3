#pragma once
// Lines and outlines with no more vertices than their shape needs.

#include <vector>

#include "tramline/geometry/point.h"

namespace tramline::io {

/// The first and the last vertex and as many of those between as it takes for every point of the line to lie
/// within `tolerance_m` of what is left, and the other way round (Douglas and Peucker). 0 leaves the line as
/// it is; a closed line stays closed. Frame: local metres. Precondition: tolerance_m >= 0. O(n log n) as a
/// rule, O(n²) at worst.
std::vector<Point> thinned(const std::vector<Point>& line, double tolerance_m);

}  // namespace tramline::io
