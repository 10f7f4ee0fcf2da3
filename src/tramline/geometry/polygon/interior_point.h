#pragma once

#include "tramline/geometry/polygon/region.h"

namespace tramline {

/// A point well inside the polygon: the middle of its widest stretch at half height (between two vertex
/// heights). Precondition: a valid polygon with area. O(n log n).
Point interior_point(const Polygon& polygon);

}  // namespace tramline
