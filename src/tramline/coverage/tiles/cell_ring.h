#pragma once
// The convex rings that tiles are made of, and how a line cuts them.

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "tramline/coverage/tiles/cell_state.h"
#include "tramline/coverage/tiles/convex_piece.h"
#include "tramline/coverage/tiles/tile_frame.h"

namespace tramline::coverage {

/// Twice the area, square units. Exact.
std::int64_t twice_area(const TilePoint* points, std::size_t count);
inline std::int64_t twice_area(const TileRing& ring) { return twice_area(ring.data(), ring.size()); }

/// A box of a tile on a grid of 2^15 a side: contains what it bounds.
struct CellBox {
  std::uint16_t min_x = 0;
  std::uint16_t min_y = 0;
  std::uint16_t max_x = 0;
  std::uint16_t max_y = 0;

  void extend(const CellBox& other) {
    min_x = std::min(min_x, other.min_x);
    min_y = std::min(min_y, other.min_y);
    max_x = std::max(max_x, other.max_x);
    max_y = std::max(max_y, other.max_y);
  }
  bool meets(const CellBox& other) const {
    return (min_x <= other.max_x) & (other.min_x <= max_x) & (min_y <= other.max_y) & (other.min_y <= max_y);
  }
};
CellBox box_of(const TileRing& ring);

/// A line as a tile sees it, with the two corners between which it bounds something.
struct TileLine {
  double nx = 0;
  double ny = 0;
  double offset = 0;
  double from_x = 0;
  double from_y = 0;
  double to_x = 0;
  double to_y = 0;

  double inside(TilePoint p) const { return nx * p.x + ny * p.y + offset; }
};
TileLine tile_line(const GridLine& line, GridPoint from, GridPoint to, GridPoint corner);

/// A convex piece as a tile sees it: what is left of all lines. Long sides first: they cut off pieces that
/// last, and short ones cut little then.
struct TilePiece {
  std::vector<TileLine> lines;
  CellBox box;
};
/// `corner`: of the tile. Precondition: the piece meets the tile, `side` units wide.
void see(const ConvexPiece& piece, GridPoint corner, std::int64_t side, TilePiece& out);

/// Splits a ring by a line; `distance`: of its points, positive inside. A part that is no wider than kOnLine
/// is empty. Crossings are rounded, but within `side`: those on the border of the tile stay there; whichever
/// way an edge is walked, and whichever side of the line is inside, its crossing is the same.
void split(const TileRing& ring, const std::vector<double>& distance, const TileLine& line, std::int64_t side,
           TileRing& inside, TileRing& outside);

}  // namespace tramline::coverage
