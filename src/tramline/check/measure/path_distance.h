#pragma once

#include "tramline/geometry/path/path.h"

namespace tramline::check {

/// Shortest distance between two segments or paths, with exact arcs, m; 0 where they meet.
double distance_between(const PathSegment& a, const PathSegment& b);
double distance_between(const Path& a, const Path& b);

}  // namespace tramline::check
