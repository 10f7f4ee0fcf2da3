#pragma once
// Compact storage for the cells of a tile: about 50 bytes each.

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "tramline/coverage/tiles/cell_ring.h"
#include "tramline/coverage/tiles/cell_state.h"

namespace tramline::coverage {

/// Cells by number, 0 … size() − 1, each with a ring and a state. They come in blocks of kBlock, each with a
/// box: cells made one after the other lie together.
class CellStore {
 public:
  static constexpr std::size_t kBlock = 16;

  std::size_t size() const { return heads_.size(); }
  CellState state(std::size_t cell) const { return heads_[cell].state; }
  const CellBox& box(std::size_t cell) const { return boxes_[cell]; }
  std::span<const TilePoint> ring(std::size_t cell) const {
    return {points_.data() + heads_[cell].first, heads_[cell].count};
  }

  /// Contains the kBlock cells from kBlock · block on.
  const CellBox& block_box(std::size_t block) const { return blocks_[block]; }

  void set_state(std::size_t cell, CellState state) { heads_[cell].state = state; }
  void add(const TileRing& ring, CellState state);
  void replace(std::size_t cell, const TileRing& ring, CellState state);
  /// Keeps the cells for which `kept` is true, reorders them so that neighbours are consecutive, and frees
  /// spare memory.
  void keep(const std::vector<bool>& kept);
  std::size_t bytes() const;

 private:
  struct Head {
    std::uint32_t first = 0;
    std::uint16_t count = 0;
    CellState state = 0;
  };
  void squeeze();
  void extend_block(std::size_t cell);

  std::vector<CellBox> boxes_;
  std::vector<CellBox> blocks_;
  std::vector<Head> heads_;
  std::vector<TilePoint> points_;
  std::size_t unused_ = 0;  ///< of points_
};

}  // namespace tramline::coverage
