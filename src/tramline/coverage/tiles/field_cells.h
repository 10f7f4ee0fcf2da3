#pragma once
// The initial partition of tiles by the field.

#include <cstdint>
#include <utility>
#include <vector>

#include "tramline/coverage/tiles/tile.h"
#include "tramline/geometry/index/span_index.h"
#include "tramline/geometry/polygon/region.h"

namespace tramline::coverage {

/// The boundary of a field on the grid, and the tiles that it crosses.
class FieldCells {
 public:
  FieldCells(const Region& field, const TileFrame& frame);

  /// Twice the area of the field, square units.
  Int128 twice_area() const { return twice_area_; }
  /// Whether the field contains a point, by the even-odd rule; units.
  bool contains(double x, double y) const;
  /// Tiles that the boundary crosses or touches, ascending.
  std::vector<TileIndex> border_tiles() const;
  /// Partitions the tile's square along the boundary into cells within the field and outside, not worked.
  /// O(cells · segments of the boundary in the tile).
  void partition(TileIndex tile, CellStore& out, CutScratch& scratch) const;

 private:
  struct Segment {
    GridPoint from;
    GridPoint to;
  };
  void cut_along(const Segment& segment, GridPoint corner, CellStore& cells, CutScratch& scratch) const;

  TileFrame frame_;
  std::vector<Segment> segments_;
  SpanIndex rows_;                                            ///< of segments, by y
  std::vector<std::pair<TileIndex, std::uint32_t>> passing_;  ///< tiles and their segments, ascending
  Int128 twice_area_ = 0;
};

}  // namespace tramline::coverage
