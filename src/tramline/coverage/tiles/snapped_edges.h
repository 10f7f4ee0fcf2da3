#pragma once
// Snaps edges of cells to common points.

#include <cstdint>
#include <vector>

#include "tramline/coverage/tiles/edge_sum.h"

namespace tramline::coverage {

struct TileEdge {
  TilePoint from;
  TilePoint to;
};

/// Points no further apart than this become one in an outline, and edges pass through points this close,
/// units. Several times the effect of rounding on cells (tile_frame.h).
inline constexpr std::int32_t kSnap = 16;

/// Closes gaps and overlaps of a few units that rounding has made between cells: points that nearly coincide
/// become one, points near the border of the tile are moved onto it, and edges are led through the points
/// that they nearly pass. Opposite edges cancel. The remaining edges meet at points only. Expected O(n log n)
/// for edges about as long as they lie apart.
EdgeSum snapped(std::vector<TileEdge> edges, std::int32_t side);

}  // namespace tramline::coverage
