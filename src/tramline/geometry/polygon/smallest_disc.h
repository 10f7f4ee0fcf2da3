#pragma once
// The smallest enclosing disc of points.

#include <vector>

#include "tramline/geometry/polygon/region.h"

namespace tramline {

/// The smallest disc that contains all points, up to kSameDistance_m. Precondition: at least one point. O(n³)
/// at worst, O(n) mostly: points inside the disc found so far cost nothing (Welzl 1991, iterated).
Disc smallest_disc(const std::vector<Point>& points);

}  // namespace tramline
