#pragma once
// Assigns holes to outer rings.

#include <cstddef>
#include <vector>

#include "tramline/coverage/tiles/grid_point.h"

namespace tramline::coverage {

using GridRing = std::vector<GridPoint>;

/// Twice the area, positive where the ring runs counter-clockwise.
Int128 twice_area(const GridRing& ring);

/// For each hole the index of the outer ring that bounds the same region; outer.size() where there is none.
/// Preconditions: outer rings counter-clockwise, holes clockwise, simple; rings meet at points only.
/// O(n log n) for rings spread evenly.
std::vector<std::size_t> parents_of(const std::vector<GridRing>& holes, const std::vector<GridRing>& outer);

}  // namespace tramline::coverage
