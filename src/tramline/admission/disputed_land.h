#pragma once
// Land for which a self-crossing ring does not determine whether it is enclosed.

#include "tramline/geometry/polygon/region.h"

namespace tramline {

/// Land the ring goes round an even number of times, but not zero times: inside by the non-zero rule, outside
/// by the even-odd rule. Precondition: at least three distinct points. O(n log n + faces·n).
Region disputed_land(const Ring& ring);

/// How many times the ring goes counter-clockwise round the point. Precondition: p is not on the ring. O(n).
int winding_number(const Ring& ring, Point p);

}  // namespace tramline
