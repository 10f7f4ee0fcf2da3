#pragma once

#include "tramline/geometry/polygon/region.h"

namespace tramline {

/// How far the point lies from the ring's nearest edge, m, on either side of it; infinity for a ring without
/// points. O(n).
double distance_to_outline(Point p, const Ring& ring);

/// How far the point lies from the nearest edge of the polygon and of its holes, m, inside and outside. O(n).
double distance_to_outline(Point p, const Polygon& polygon);

}  // namespace tramline
