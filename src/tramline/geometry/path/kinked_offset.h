#pragma once
// The offset of a polyline, kinks and all (∥ of S2.2).

#include <vector>

#include "tramline/geometry/point.h"

namespace tramline {

/// The polyline `offset_m` to the right of another (negative: to the left). Every edge moves by the offset;
/// at kinks edges meet in a mitre, and kinks that turn away by more than 120° are cut by an edge of their own
/// at the offset's distance. An edge that has shrunk to nothing on the way is left out, and those beside it
/// meet. Where the line then crosses itself what is nearer than the offset is cut away; of several lines
/// that are left the longest one from end to end is the offset, and lobes closed in themselves are lost.
/// Empty where nothing is left.
/// Precondition: no two points in a row coincide, at least two. O(n·e + n log n) for n points of which e
/// vanish; O(n²) where the offset crosses itself.
std::vector<Point> kinked_offset(const std::vector<Point>& line, double offset_m);

}  // namespace tramline
