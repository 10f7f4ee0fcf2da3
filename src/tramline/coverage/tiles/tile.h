#pragma once
// A tile: a partition of its square into convex cells, and what working a convex piece does to it.

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

/// Memory that is used again and again.
struct CutScratch {
  std::vector<double> distance;
  std::vector<char> cutting;  ///< of each line: whether it cuts the cell
  TileRing ring;
  TileRing inside;
  std::vector<TileRing> outside;
};

/// Gives every cell's part within the piece the state that `next` has for it. Cells that the piece does not
/// meet, or whose state stays, are not touched. Areas move in `totals`. Returns whether anything changed.
/// O(cells), and O(corners · lines) for those that the piece's box meets.
bool apply(const TilePiece& piece, const Transition& next, StateSet changing, std::int64_t side, Tile& tile,
           Totals& totals, CutScratch& scratch);

/// Whether the piece covers any ground in one of these states.
bool covers(const TilePiece& piece, StateSet states, std::int64_t side, const Tile& tile,
            CutScratch& scratch);

/// Adds what the cells of a tile measure.
void add_areas(const CellStore& cells, Totals& totals);

}  // namespace tramline::coverage
