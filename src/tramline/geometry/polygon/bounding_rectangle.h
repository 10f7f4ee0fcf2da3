#pragma once
// Convex hulls and the directions of the smallest rectangle and of the least width.

#include "tramline/geometry/angle.h"
#include "tramline/geometry/polygon/region.h"

namespace tramline {

/// Convex hull, counter-clockwise, without collinear points (Andrew's monotone chain). O(n log n).
Ring hull_of(std::vector<Point> points);

/// Direction of the longer side of the bounding rectangle of least area (Versleijen §2.2.1; Toussaint 1983:
/// one side lies on a hull edge). Ties (relative 1e-9), which every triangle has, go to the slimmest
/// rectangle, then to the smaller direction. Precondition: area > 0.
Direction long_side_of_smallest_rectangle(const Ring& ring);

/// Direction perpendicular to the least width (the least altitude over the hull's edges): tracks in
/// this direction are fewest. Ties as above. Precondition: area > 0.
Direction across_least_width(const Ring& ring);

}  // namespace tramline
