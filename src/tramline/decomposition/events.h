#pragma once
// The vertices at which the sweep splits a field (Versleijen §2.2.2).

#include <vector>

#include "tramline/geometry/angle.h"
#include "tramline/geometry/polygon/region.h"

namespace tramline {

/// A vertex whose field-side interior angle exceeds the decomposition threshold (Versleijen's event 1).
struct SplitEvent {
  Point previous, vertex, next;  ///< consecutive on the ring, the field on the left
};

/// Angle on the field's side between the edges previous → vertex → next of an oriented ring, in
/// (0, 360) degrees; 180 on a straight line.
Angle interior_angle(Point previous, Point vertex, Point next);

/// All split events of an oriented polygon, outer ring first. Corners between two edges that are both shorter
/// than `short_edge_m` split nothing (Versleijen §4.2.1): they come from how the boundary was measured, not
/// from the field. O(n).
std::vector<SplitEvent> split_events(const Polygon& polygon, Angle threshold, double short_edge_m = 0);

}  // namespace tramline
