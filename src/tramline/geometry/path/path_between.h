#pragma once
// The part of a path between two positions.

#include "tramline/geometry/path/path.h"

namespace tramline {

/// The path between two positions along it. Precondition: from < to, both on the path.
Path path_between(const Path& path, double from, double to);

}  // namespace tramline
