#pragma once
// Self-crossings of paths.

#include <optional>

#include "tramline/geometry/path/path.h"

namespace tramline::check {

/// A point where the path crosses itself; nullopt where there is none. Parts that touch, or that overlap by a
/// few millimetres and separate again on the side they came from, do not cross. Precondition: the path has no
/// fault (fault_of). O(n log n) for n chords that do not crowd.
std::optional<Point> self_crossing_of(const Path& path);

}  // namespace tramline::check
