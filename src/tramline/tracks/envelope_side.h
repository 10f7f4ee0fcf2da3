#pragma once
// The side of a body's envelope on which straight tracks begin (Zhou §2.3.4).

#include <utility>

#include "tramline/geometry/polygon/region.h"

namespace tramline {

/// The side l of the envelope of the body, the rectangle round it with sides parallel to the line from `a` to
/// `b`: the side on the left of the line as seen from a to b, so that all of the body lies on its right, and
/// the tracks at w/2 + (i − 1)·w from it are those of the paper. All parts of the body share one envelope. It
/// begins and ends where the envelope does, and has the heading of the line. Frame: that of the body, metres.
/// Preconditions: a != b; the body is not empty. O(n).
std::pair<Point, Point> envelope_side(Point a, Point b, const Region& body);

}  // namespace tramline
