#pragma once
// The area that the straight swaths of a subfield work, as one region.

#include "tramline/geometry/interval.h"
#include "tramline/geometry/polygon/faces.h"
#include "tramline/geometry/polygon/region.h"
#include "tramline/tracks/laid_pieces.h"

namespace tramline {

/// The union of the swaths of all straight parts, in the field's frame: swaths of one grid share strip lines,
/// so the union is a walk along these instead of a polygon boolean. Parts may touch in corners. O(n log n)
/// for n pieces.
Region worked_rows(const LaidTracks& tracks);

/// Appends the edges along the line at the coordinate across `line` between two strips of which these parts
/// are worked: upwards where only the left one is, downwards where only the right one is. Plane: x across, y
/// along.
void append_edges_along(double line, const Intervals& left, const Intervals& right,
                        std::vector<DirectedEdge>& out);

}  // namespace tramline
