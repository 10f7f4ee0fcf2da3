#pragma once
// The ground of headlands from its definition: what is nearer to a boundary than a distance.

#include "tramline/geometry/polygon/region.h"

namespace tramline::check {

/// Land beside a ring: all of it, left of the ring, that is nearer to it than `distance_m`, and some land
/// right of it. The strips along its edges and the fans about its corners that stand out to the left,
/// united; the fans of chords inside their arcs by at most kFanSagitta_m. No buffer: GEOS buffers simplify
/// what goes in by a hundredth of the distance. O(n log n) for n vertices where few strips overlap.
Region land_near(const Ring& ring, double distance_m);

/// Length of the arcs that the fans stand for, m.
double arcs_about_corners_m(const Ring& ring, double distance_m);

}  // namespace tramline::check
