#pragma once
// Amounts in cells of an unbounded grid.

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <unordered_map>
#include <vector>

#include "tramline/coverage/dose/cell_parts.h"
#include "tramline/model/cell_grid.h"

namespace tramline::coverage {

/// Cells of the grid through the origin; only blocks of them that got something take memory.
class LaidCells {
 public:
  explicit LaidCells(double cell_m) : cell_m_(cell_m) {}

  /// Throws kBadInput where the box round all cells has more than kMostCells. O(parts).
  void add(std::span<const CellPart> parts);

  /// The cells that hold all that was laid and the box, and all of that again wherever in `reach` it is moved
  /// by. Throws kBadInput where they are more than kMostCells.
  CellGrid grid(const Box& box, const Box& reach) const;
  /// Precondition: a grid() of these cells.
  std::vector<double> amounts(const CellGrid& grid) const;

 private:
  static constexpr std::int64_t kSide = 64;
  using Block = std::array<double, kSide * kSide>;
  struct Place {
    std::int64_t column = 0;
    std::int64_t row = 0;
    bool operator==(const Place&) const = default;
  };
  struct HashPlace {
    std::size_t operator()(const Place& place) const {
      return static_cast<std::size_t>(place.column * 0x9E3779B97F4A7C15LL ^ place.row);
    }
  };

  Block& block_at(Place place);

  double cell_m_;
  std::unordered_map<Place, std::unique_ptr<Block>, HashPlace> blocks_;
  Place last_;
  Block* last_block_ = nullptr;
  std::int64_t low_column_ = 0, high_column_ = -1, low_row_ = 0, high_row_ = -1;  ///< of blocks
};

/// Throws kBadInput, saying which cells would do, for more than kMostCells of this side over such ground.
void require_few_cells(double wide_m, double high_m, double cell_m);

}  // namespace tramline::coverage
