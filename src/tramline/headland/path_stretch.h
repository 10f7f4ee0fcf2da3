#pragma once
// Parts of a path by length.

#include "tramline/geometry/path/path.h"

namespace tramline {

/// The path between two positions along it, m. On a path that ends where it begins `to_m` may lie beyond its
/// end: it continues from the beginning. Parts shorter than a micrometre at an end of a segment are left out.
/// Precondition: 0 ≤ from_m < to_m, which is at most the path's length, or twice that where it is closed.
/// O(n).
Path stretch_of(const Path& path, double from_m, double to_m);

/// Where along the path it is nearest to a point, m. O(n).
double nearest_along_m(const Path& path, Point to);

}  // namespace tramline
