#pragma once
// A tile: a partition of its square into convex cells, and its change by working a convex piece.

#include <cstdint>
#include <vector>

#include "tramline/coverage/tiles/cell_store.h"

namespace tramline::coverage {

struct Tile {
  TileIndex index;
  CellStore cells;
  std::uint64_t changed = 0;  ///< stamp of its last change
  std::size_t merge_at = 0;   ///< cells are merged once there are that many
};

/// Scratch memory that is reused.
struct CutScratch {
  std::vector<double> distance;
  std::vector<char> cutting;  ///< for each line whether it cuts the cell
  TileRing ring;
  TileRing inside;
  std::vector<TileRing> outside;
};

/// Applies `next` to the state of every cell's part within the piece. Cells that the piece does not overlap,
/// or whose state does not change, are left alone. Updates `totals`. Returns whether anything changed.
/// O(cells), and O(corners · lines) for those that the piece's box overlaps.
bool apply(const TilePiece& piece, const Transition& next, StateSet changing, std::int64_t side, Tile& tile,
           Totals& totals, CutScratch& scratch);

/// Whether the piece covers any land in one of these states.
bool covers(const TilePiece& piece, StateSet states, std::int64_t side, const Tile& tile,
            CutScratch& scratch);

/// Adds the areas of the cells of a tile to `totals`.
void add_areas(const CellStore& cells, Totals& totals);

}  // namespace tramline::coverage
