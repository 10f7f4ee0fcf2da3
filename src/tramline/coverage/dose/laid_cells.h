#pragma once
// Amounts applied to cells of an unbounded grid.

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <unordered_map>
#include <vector>

#include "tramline/coverage/dose/cell_parts.h"
#include "tramline/model/cell_grid.h"

namespace tramline::coverage {

/// Cells of the grid through the origin; only blocks of cells that received an amount take memory.
class LaidCells {
 public:
  explicit LaidCells(double cell_m) : cell_m_(cell_m) {}

  /// Throws kBadInput where the box round all cells has more than kMostCells. O(parts).
  void add(std::span<const CellPart> parts);

  /// The grid of cells that contains the box and all applied amounts, also when these are moved by any offset
  /// in `reach`. Throws kBadInput where it has more than kMostCells.
  CellGrid grid(const Box& box, const Box& reach) const;
  /// The amounts of the cells of a grid. Precondition: a grid() of these cells.
  std::vector<double> amounts(const CellGrid& grid) const;

 private:
  static constexpr std::int64_t kSide = 64;
  using Block = std::array<double, kSide * kSide>;
  struct CellIndex {
    std::int64_t column = 0;
    std::int64_t row = 0;
    bool operator==(const CellIndex&) const = default;
  };
  struct HashIndex {
    std::size_t operator()(const CellIndex& index) const {
      return static_cast<std::size_t>(index.column * 0x9E3779B97F4A7C15LL ^ index.row);
    }
  };

  Block& block_at(CellIndex index);

  double cell_m_;
  std::unordered_map<CellIndex, std::unique_ptr<Block>, HashIndex> blocks_;
  CellIndex last_;
  Block* last_block_ = nullptr;
  std::int64_t low_column_ = 0, high_column_ = -1, low_row_ = 0, high_row_ = -1;  ///< of blocks
};

/// Throws kBadInput, naming a sufficient cell size, for more than kMostCells of this side over an area of
/// this size.
void require_few_cells(double wide_m, double high_m, double cell_m);

}  // namespace tramline::coverage
