#pragma once
// The offset of a polyline with its kinks (∥ of Zhou §2.2).

#include <vector>

#include "tramline/geometry/point.h"

namespace tramline {

/// The polyline `offset_m` to the right of another (negative: to the left). Every edge moves by the offset;
/// at kinks edges meet in a mitre, and kinks that turn away by more than 120° are cut by an edge of their own
/// at the offset's distance. An edge that shrinks to nothing on the way is left out, and its neighbours meet.
/// Where the line then crosses itself, the parts nearer than the offset are cut away; of several remaining
/// lines the longest one from end to end is the offset, and closed lobes are lost. Empty where nothing
/// remains. Precondition: at least two points, no two consecutive ones coincide. O(n·e + n log n) for n
/// points of which e vanish; O(n²) where the offset crosses itself.
std::vector<Point> kinked_offset(const std::vector<Point>& line, double offset_m);

}  // namespace tramline
