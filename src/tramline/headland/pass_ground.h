#pragma once
// The area that a headland pass works, as polygons.

#include "tramline/geometry/path/path.h"
#include "tramline/geometry/polygon/region.h"

namespace tramline {

/// The parts of the area of a pass: one where its swath does not meet itself, else those of its halves, and
/// so on, which touch and may overlap; where it has kinks its cells (kinked_cells()). Arcs as chords, which
/// deviate by at most `sagitta_m`. Frame: that of the path. A path that ends where it begins has a
/// ring-shaped area, any other ends flat. O(n log² n).
Region pass_ground_parts(const Path& path, double width_m, double sagitta_m);

}  // namespace tramline
