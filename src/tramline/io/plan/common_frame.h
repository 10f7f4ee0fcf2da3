#pragma once
// The common plane of the plans of many fields.

#include <functional>
#include <vector>

#include "tramline/geometry/point.h"
#include "tramline/model/local_frame.h"

namespace tramline::io {

/// The common frame: a transverse Mercator centred on all frames or, for plain frames, the input plane.
/// Throws Error(kBadInput) where some are plain and some not. Precondition: frames is not empty. O(n).
LocalFrame common_frame(const std::vector<LocalFrame>& frames);

/// A conversion of local metres of one frame to those of another, both of the same kind. Not for several
/// threads at once. Throws Error(kBadInput) where a point has no position in the other frame.
std::function<Point(Point)> way_between(const LocalFrame& from, const LocalFrame& to);

}  // namespace tramline::io
