#pragma once
// Square tiles over the grid of meshes, for readers that follow what changes.

#include <cstdint>
#include <map>
#include <vector>

#include "tramline/coverage/mesh/mesh_region.h"
#include "tramline/coverage/tiles/tile_frame.h"

namespace tramline::coverage {

/// Which tiles changed when. Each corner of the grid belongs to one tile; a region is that of its corners in
/// all tiles.
class MeshTiles {
 public:
  /// `side`: corners to a side of a tile. Precondition: side > 0.
  explicit MeshTiles(int side);

  /// Notes that the tiles that hold corners of the region change with the next stamp. O(rows + tiles).
  void touch(const MeshRegion& changed);
  /// Ends a step; what was touched in it counts as changed from then on.
  void end_step();
  std::uint64_t stamp() const { return stamp_; }

  /// The tiles that changed after `stamp`, an earlier value of stamp(); 0: all that ever did. By row, then by
  /// column. O(tiles).
  std::vector<TileIndex> changed_since(std::uint64_t stamp) const;
  /// The part of a region in one tile. O(meshes of the region beside the tile).
  MeshRegion part(const MeshRegion& region, TileIndex tile) const;

 private:
  std::int32_t tile_at(std::int32_t corner) const;

  int side_;
  std::uint64_t stamp_ = 0;
  bool touched_ = false;
  std::map<TileIndex, std::uint64_t> changed_;
};

}  // namespace tramline::coverage
