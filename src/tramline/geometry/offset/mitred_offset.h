#pragma once
// The offset of polygons as Zhou et al. 2020 draw it (∥ of Zhou §2.2): edges stay edges, and corners corners.

#include "tramline/geometry/polygon/region.h"

namespace tramline {

/// The region without the land that the edges of its rings pass over as they move inwards by `distance_m`. At
/// corners that stand out into the region two edges go on until they meet in a mitre; turns of more than 120°
/// are cut by an edge of their own at the distance. Vertices within kMitredIdle_m of a ring through the
/// others are left out. On the precision grid, free of parts without area; may fall into several, and be
/// empty. Precondition: distance_m > 0. O(n log n) where few edges are near to one another.
Region mitred_inset(const Region& region, double distance_m);

/// The same outwards: the region with the land that the edges pass over. Parts that meet become one; holes
/// shrink. Precondition: as above.
Region mitred_outset(const Region& region, double distance_m);

/// The region without parts, and without holes, that are nowhere wider than about kMitredIdle_m: where strips
/// of edges meet on the precision grid, booleans leave some.
Region without_slivers(Region region);

/// The ring through the vertices that matter to an offset; empty where it is nowhere wider than the
/// tolerance.
Ring without_idle_corners(const Ring& ring);

}  // namespace tramline
