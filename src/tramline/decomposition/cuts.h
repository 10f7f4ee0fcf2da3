#pragma once
// The lines along which the sweep cuts a polygon (Versleijen §2.2.2).

#include <vector>

#include "tramline/decomposition/events.h"
#include "tramline/geometry/strip/track_frame.h"

namespace tramline {

/// A cut from an event's vertex through the field's inside to the next boundary.
struct Cut {
  Point from;     ///< the vertex
  Point to;       ///< a vertex, or a point on `edge`
  int ring = -1;  ///< the ring hit between two vertices (0: outer, then the holes); −1: a vertex is hit
  std::size_t edge = 0;  ///< the edge hit, by its first vertex
};

/// For every event the stretches of the line through its vertex, parallel to `direction`, that run through
/// the field's inside to either side. There is none on a side where the line leaves the field or follows an
/// edge at once. O(n + k) for k edges that the lines meet.
std::vector<Cut> cuts_at(const Polygon& polygon, const std::vector<SplitEvent>& events, Direction direction);

/// The parts the cuts divide the polygon into; parts that touch share identical edges. O(n log n).
Region divided(const Polygon& polygon, const std::vector<Cut>& cuts);

}  // namespace tramline
