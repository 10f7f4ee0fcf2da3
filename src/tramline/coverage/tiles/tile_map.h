#pragma once
// The tiles that were worked in, by index.

#include <cstdint>
#include <deque>
#include <unordered_map>
#include <vector>

#include "tramline/coverage/tiles/field_cells.h"
#include "tramline/coverage/tiles/tile.h"

namespace tramline::coverage {

/// Tiles are made on first use, and their addresses stay valid.
class TileMap {
 public:
  /// The tile, or nullptr. O(1).
  Tile* find(TileIndex index);
  const Tile* find(TileIndex index) const;
  /// The tile; new ones are partitioned by the field.
  Tile& at(TileIndex index, const FieldCells& field, CutScratch& scratch);

  const std::deque<Tile>& tiles() const { return tiles_; }  ///< in the order of their making

 private:
  static std::uint64_t key(TileIndex index) {
    return static_cast<std::uint64_t>(static_cast<std::uint32_t>(index.row)) << 32 |
           static_cast<std::uint32_t>(index.column);
  }
  struct Hash {
    std::size_t operator()(std::uint64_t key) const {
      return static_cast<std::size_t>((key ^ key >> 31) * 0x9E3779B97F4A7C15ULL >> 16);
    }
  };

  std::deque<Tile> tiles_;
  std::unordered_map<std::uint64_t, Tile*, Hash> by_index_;
  Tile* last_ = nullptr;  ///< the last one used, usually also the next
};

}  // namespace tramline::coverage
