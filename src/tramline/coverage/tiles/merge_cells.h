#pragma once
// Merges neighbouring cells in the same state whose union is convex.

#include <cstdint>
#include <vector>

#include "tramline/coverage/tiles/tile.h"

namespace tramline::coverage {

/// Scratch memory that is reused.
struct MergeMemory {
  struct Entry {
    TilePoint from;
    TilePoint to;
    std::uint32_t cell = 0;
    bool used = false;
  };
  std::vector<Entry> table;         ///< directed edges by hash, with their cells
  std::vector<std::uint32_t> into;  ///< for each cell the one that it was merged into, or itself
  TileRing ring;
};

/// Merges cells that share a whole edge until no two can be merged. Corners no further than kStraight from
/// the line between their neighbours are removed; `totals` is adjusted accordingly. The result depends on the
/// cells and their order alone. Expected O(edges).
void merge_cells(Tile& tile, Totals& totals, MergeMemory& memory);

/// Merges when the tile has grown to twice the number of cells it had after the last merge.
void merge_when_due(Tile& tile, Totals& totals, MergeMemory& memory);

}  // namespace tramline::coverage
