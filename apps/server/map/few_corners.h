#pragma once
// Shapes with fewer corners, for the screen.

#include <vector>

#include "tramline/geometry/point.h"
#include "tramline/geometry/polygon/region.h"

namespace tramline::server {

/// The corners of a ring that tell, within `share` of its size: for pictures of a field that are a few pixels
/// wide. All of them where fewer than three would be left. O(n log n), mostly, like the others.
Ring few_corners(const Ring& ring, double share);

/// A line that deviates by `detail_m` at most; 0: as it is.
std::vector<Point> thinned_line(const std::vector<Point>& line, double detail_m);

/// The same of all rings; those that would have fewer than three corners stay as they are.
Polygon thinned_polygon(const Polygon& polygon, double detail_m);

}  // namespace tramline::server
