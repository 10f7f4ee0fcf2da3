#pragma once
// The paths that the machine drives, from the lines of the turning circle's centre.

#include "tramline/geometry/offset/offset_rings.h"

namespace tramline {

/// The closed path drawn by the far side of a disc of radius `radius_m` whose centre goes along the ring.
/// Where the ring turns to the left, the path turns along the disc; an arc of the ring makes an arc smaller
/// by the radius. Precondition: the ring's arcs are larger than the radius.
Path closed_path(const OffsetRing& ring, double radius_m);

/// The same for an open line of the centre: the path begins and ends where the disc touches at its ends.
/// Empty where the line has no length.
Path open_path(const OffsetRing& way, double radius_m);

/// The part of the path that the disc draws where its centre turns to the left from one heading, a unit
/// vector, to another, by half a circle at most; empty where there is no turn.
Path turn_about(Point centre, double radius_m, Point heading_before, Point heading_after);

}  // namespace tramline
