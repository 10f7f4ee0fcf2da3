#pragma once
// Edges of cells, snapped to the coarse grid.

#include <cstdint>
#include <vector>

#include "tramline/coverage/edge_sum.h"

namespace tramline::coverage {

struct TileEdge {
  TilePoint from;
  TilePoint to;
};

/// Snap rounding: every edge becomes the chain of the coarse points whose squares it passes, of those at
/// which any edge ends. Edges that did not cross do not cross afterwards; cells that rounding had pulled
/// apart or pushed over one another by a few units meet again, at each other's vertices. Coordinates of the
/// result are coarse. Edges walked both ways cancel. Expected O(n log n) for edges about as long as they lie
/// apart.
EdgeSum snapped(const std::vector<TileEdge>& edges, std::int64_t side);

}  // namespace tramline::coverage
