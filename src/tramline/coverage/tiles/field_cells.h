#pragma once
// The field as tiles see it: the first partition of each.

#include <cstdint>
#include <utility>
#include <vector>

#include "tramline/coverage/tiles/tile.h"
#include "tramline/geometry/index/span_index.h"
#include "tramline/geometry/polygon/region.h"

namespace tramline::coverage {

/// The boundary of a field on the grid, and which tiles it passes.
class FieldCells {
 public:
  FieldCells(const Region& field, const TileFrame& frame);

  /// Twice the area of the field, square units.
  Int128 twice_area() const { return twice_area_; }
  /// Even-odd; units.
  bool contains(double x, double y) const;
  /// Tiles that the boundary passes or touches, ascending.
  std::vector<TileIndex> border_tiles() const;
  /// The tile's square, cut along the boundary; each cell within the field or outside, not worked.
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
