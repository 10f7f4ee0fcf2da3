#pragma once
// Bands whose chords do not depend on where an arc begins.

#include "tramline/geometry/path/path.h"

namespace tramline {

/// As band(), except that arcs of one circle have the same chords whatever part of it they are: bands that
/// lie on one another have the same vertices, up to rounding, and no slivers between their chords but at the
/// ends of arcs. O(n) for n vertices of the result.
Ring band_on_circles(const Path& path, double width_m, double sagitta_m);

}  // namespace tramline
