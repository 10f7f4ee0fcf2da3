#pragma once
// From where the centre of the turning circle may be to what the machine drives.

#include "tramline/geometry/offset/offset_rings.h"

namespace tramline {

/// The closed path that a disc of radius `radius_m` draws whose centre goes along the ring: on the disc's far
/// side. Where the ring turns to the left, the path does so along the disc; an arc of the ring makes an arc
/// smaller by the radius. Precondition: the ring's arcs are larger than the radius.
Path closed_path(const OffsetRing& ring, double radius_m);

/// The same for a way of the centre that has two ends: the path begins and ends where the disc touches there.
/// Empty where the way has no length.
Path open_path(const OffsetRing& way, double radius_m);

/// The part of it that the disc draws where its centre turns to the left from one heading, a unit vector, to
/// another, half a circle at most; empty where that is no turn.
Path turn_about(Point centre, double radius_m, Point heading_before, Point heading_after);

}  // namespace tramline
