#pragma once
// Fewer cells: neighbours in the same state whose union is convex become one.

#include <cstdint>
#include <vector>

#include "tramline/coverage/tiles/tile.h"

namespace tramline::coverage {

/// Memory that is used again and again.
struct MergeMemory {
  struct Entry {
    TilePoint from;
    TilePoint to;
    std::uint32_t cell = 0;
    bool used = false;
  };
  std::vector<Entry> table;         ///< directed edges by hash, and whose they are
  std::vector<std::uint32_t> into;  ///< of each cell the one that it was merged into, or itself
  TileRing ring;
};

/// Merges cells that share a whole edge, until no two can be. Corners no further than kStraight off the line
/// between their neighbours go; areas move in `totals` by what that does. Depends on the cells and their
/// order alone. Expected O(edges).
void merge_cells(Tile& tile, Totals& totals, MergeMemory& memory);

/// Merges where the tile has grown to twice the cells it had after the last time.
void merge_when_due(Tile& tile, Totals& totals, MergeMemory& memory);

}  // namespace tramline::coverage
