#pragma once
// Edges of cells, made to meet at common points.

#include <cstdint>
#include <vector>

#include "tramline/coverage/tiles/edge_sum.h"

namespace tramline::coverage {

struct TileEdge {
  TilePoint from;
  TilePoint to;
};

/// Points no further apart than this are one in an outline, and edges pass through a point so close, units.
/// Several times what rounding can do to cells (tile_frame.h).
inline constexpr std::int32_t kSnap = 16;

/// Cells that rounding has pulled apart or pushed over one another by a few units meet again: points that all
/// but coincide become one, those that close to the border of the tile lie on it, and edges run through the
/// points that they all but pass. Edges walked both ways cancel. What is left meets at points only. Expected
/// O(n log n) for edges about as long as they lie apart.
EdgeSum snapped(std::vector<TileEdge> edges, std::int32_t side);

}  // namespace tramline::coverage
