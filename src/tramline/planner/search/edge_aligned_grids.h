#pragma once
// The grids that lie flush with an edge.

#include "tramline/planner/search/grid_pricing.h"

namespace tramline {

/// One for each direction of edges, flush with the longest of them, `most` at the most: those first whose
/// edges sum up to the greatest length. Offsets are from the pivot, as in a GridPosition. O(n log n).
std::vector<GridPosition> edge_aligned_grids(const Polygon& part, Point pivot, std::size_t most);

}  // namespace tramline
