#pragma once
// The boundary of a region within a tile.

#include <cstdint>
#include <vector>

#include "tramline/coverage/tiles/cell_store.h"
#include "tramline/coverage/tiles/edge_sum.h"

namespace tramline::coverage {

/// A stretch of boundary along the border between tiles, with the region on its left; units.
struct BorderEdge {
  bool upright = false;   ///< along a column's border; else along a row's
  std::int32_t line = 0;  ///< the number of the column east of it, or of the row north of it
  std::int64_t from = 0;  ///< along it; from = to: only marks a point where another edge ends
  std::int64_t to = 0;
};

/// Frame: units from the tile's corner. Chains have the region on their left, and forks only at their ends;
/// closed ones end where they begin.
struct TileOutline {
  TileIndex tile;
  std::vector<TilePoint> points;    ///< of all chains, one after another
  std::vector<std::uint32_t> ends;  ///< for each chain, one past its last point
  std::vector<BorderEdge> border;
};

/// The boundary of the cells in one of these states. O(n log n).
TileOutline outline_of(TileIndex tile, const CellStore& cells, StateSet states, std::int64_t side);

}  // namespace tramline::coverage
