#pragma once
// The land of headlands by its definition: all that is nearer to a boundary than a distance.

#include "tramline/geometry/polygon/region.h"

namespace tramline::check {

/// Land beside a ring: all of it, left of the ring, that is nearer to it than `distance_m`, and some land
/// right of it. It is the union of strips along the edges and of fans about the corners that are convex to
/// the left; the chords of fans lie inside their arcs by at most kFanSagitta_m. GEOS buffers are not used
/// because they simplify their input by a hundredth of the distance. O(n log n) for n vertices where few
/// strips overlap.
Region land_near(const Ring& ring, double distance_m);

/// The same beside a line of two points or more, without fans about its ends; the strips and fans may
/// overlap.
Region land_near_line(const std::vector<Point>& line, double distance_m);

/// The region without the land that its edges pass over as they move inwards `distance_m`, and the region
/// with the land that they pass over outwards: corners that part end in mitres, turns of more than 120° flat
/// at the distance. Vertices within kThinnestShown_m of the line through their neighbours do not count. O(n
/// log n) for n vertices where few edges are near one another.
Region moved_inwards(const Region& region, double distance_m);
Region moved_outwards(const Region& region, double distance_m);

/// Total length of the arcs that the fans approximate, m.
double arcs_about_corners_m(const Ring& ring, double distance_m);

}  // namespace tramline::check
