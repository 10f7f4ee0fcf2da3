#pragma once
// Parts of a path by length.

#include "tramline/geometry/path/path.h"

namespace tramline {

/// The path from one length along it to another, m. Of a path that ends where it begins `to_m` may lie beyond
/// its end: it goes on from the beginning. What would be shorter than a micrometre at an end of a segment is
/// left out. Precondition: 0 ≤ from_m < to_m, which is at most the path's length, or twice that where it is
/// closed. O(n).
Path stretch_of(const Path& path, double from_m, double to_m);

}  // namespace tramline
