#pragma once
// The plane that the plans of many fields are put into, each from its own.

#include <functional>
#include <vector>

#include "tramline/geometry/point.h"
#include "tramline/model/local_frame.h"

namespace tramline::io {

/// In the middle of all: a transverse Mercator, or for plain frames the input plane. Throws Error(kBadInput)
/// where some are plain and some not. Precondition: frames is not empty. O(n).
LocalFrame common_frame(const std::vector<LocalFrame>& frames);

/// From local metres of one frame to those of another, both of the same kind. Not for several threads at
/// once. Throws Error(kBadInput) where the other has no such place.
std::function<Point(Point)> way_between(const LocalFrame& from, const LocalFrame& to);

}  // namespace tramline::io
