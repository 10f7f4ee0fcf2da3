#pragma once
// The land between two obstacles, or an obstacle and the edge, that are too close together for the machine to
// pass.

#include "tramline/geometry/polygon/region.h"

namespace tramline {

/// The land between a ring (taken as a line) and a region that are closer together than `gap_m`: for every
/// edge of the ring the hull of the region's part nearer than gap_m and of that part's projections on the
/// edge. A gap up to 1 % wider is bridged too, so that rounding leaves no slit; the result is empty where the
/// two are farther apart. May reach into the region and across the ring: clip it.
Region bridge(const Ring& ring, const Region& region, double gap_m);

}  // namespace tramline
