#pragma once
// The convex rings that tiles consist of, and their division by a line.

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

/// A box in a tile on a grid of 2^15 a side; rounded outwards.
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

/// A line in the coordinates of a tile, with the two corners between which it bounds a piece.
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

/// A convex piece in the coordinates of a tile: the intersection of the left sides of all lines. Long sides
/// come first: they cut off parts that last, after which short ones cut little.
struct TilePiece {
  std::vector<TileLine> lines;
  CellBox box;
};
/// Converts a piece to the coordinates of a tile. `corner`: that of the tile. Precondition: the piece
/// overlaps the tile, which is `side` units wide.
void see(const ConvexPiece& piece, GridPoint corner, std::int64_t side, TilePiece& out);

/// Splits a ring by a line. `distance`: that of each point, positive inside. A part that is no wider than
/// kOnLine is empty. Crossings are rounded, but within `side`: those on the border of the tile stay there;
/// whichever way an edge is walked, and whichever side of the line is inside, its crossing is the same.
void split(const TileRing& ring, const std::vector<double>& distance, const TileLine& line, std::int64_t side,
           TileRing& inside, TileRing& outside);

}  // namespace tramline::coverage
