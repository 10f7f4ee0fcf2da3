#pragma once
// The smallest disc round points.

#include <vector>

#include "tramline/geometry/polygon/region.h"

namespace tramline {

/// The smallest disc that contains all points, up to kSameDistance_m. Precondition: at least one point.
/// O(n³) at worst, O(n) mostly: points that the disc so far contains cost nothing (Welzl 1991, iterated).
Disc smallest_disc(const std::vector<Point>& points);

}  // namespace tramline
