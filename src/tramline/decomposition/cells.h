#pragma once
// The cells of one sweep direction and their own driving directions (Versleijen §2.2.2 and §2.2.1).

#include "tramline/geometry/angle.h"
#include "tramline/geometry/polygon/region.h"
#include "tramline/model/plan.h"

namespace tramline {

/// A part of the field cut out by the sweep; not convex where the threshold exceeds 180 degrees.
struct Cell {
  Polygon shape;
  Direction direction;
};

/// Cuts every polygon of the plannable land at its split events, parallel to `sweep`. The cells of one
/// polygon share identical edges, and their union is the polygon.
std::vector<Cell> sweep_cells(const Region& plannable, Direction sweep, Angle threshold, CellDirection choice,
                              double short_edge_m = 0);

/// The driving direction of a cell: by Versleijen §2.2.1, or perpendicular to the true least width.
Direction driving_direction(const Ring& outer, CellDirection choice);

}  // namespace tramline
