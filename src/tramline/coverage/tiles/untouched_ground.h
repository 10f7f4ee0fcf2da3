#pragma once
// The part of the field in tiles that were never worked in.

#include <functional>
#include <vector>

#include "tramline/coverage/tiles/field_cells.h"
#include "tramline/coverage/tiles/tile_outline.h"

namespace tramline::coverage {

/// The boundaries of that part: tiles that the field's boundary crosses are listed one by one, the others in
/// runs.
struct UntouchedGround {
  std::vector<TileIndex> border_tiles;
  std::vector<BorderEdge> border;  ///< of runs of tiles wholly within the field
};

/// `touched`: ascending. O(tiles of the field's boundary + touched tiles).
UntouchedGround untouched_ground(const FieldCells& field, const std::vector<TileIndex>& touched,
                                 const TileFrame& frame);

}  // namespace tramline::coverage
