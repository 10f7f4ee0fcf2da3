#pragma once
// Thins lines and outlines to the vertices that their shape needs.

#include <vector>

#include "tramline/geometry/point.h"

namespace tramline::io {

/// The first and the last vertex, and enough of those between that every point of the line lies within
/// `tolerance_m` of the result and vice versa (Douglas and Peucker). 0 keeps the line as it is; a closed line
/// stays closed. Frame: local metres. Precondition: tolerance_m >= 0. O(n log n) as a rule, O(n²) at worst.
std::vector<Point> thinned(const std::vector<Point>& line, double tolerance_m);

/// Throws Error(kBadInput) where a tolerance typed by the user is not from 0 to 10 m.
void require_tolerance(double tolerance_m);

}  // namespace tramline::io
