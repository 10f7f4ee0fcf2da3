#pragma once
// What strips of a grid hold of the ring of an obstacle. Turned plane: x across the tracks, y along, m. O(n).

#include <vector>

#include "tramline/geometry/interval.h"
#include "tramline/geometry/polygon/region.h"

namespace tramline {

/// Extent along of the part of a ring between two coordinates across. Empty (from > to) where there is none,
/// as where left > right: of a strip that may lie in many places nothing is between for sure.
Interval extent_along(const Ring& ring, double left, double right);

/// The corners of a ring in some rows, and the points where it enters and leaves them. Precondition:
/// rows.from
/// <= rows.to.
std::vector<Point> corners_in(const Ring& ring, const Interval& rows);

/// Whether a ring has no bays along the tracks: what a strip holds of its inside is connected then, and is in
/// the way of the strip's track in one gap.
bool has_no_bays(const Ring& ring);

/// The ends of what a ring has of its edges within a box.
std::vector<Point> ends_within(const Ring& ring, const Box& box);

}  // namespace tramline
