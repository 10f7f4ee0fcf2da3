#include "tramline/coverage/dose/laid_cells.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "tramline/geometry/error.h"

namespace tramline::coverage {
namespace {

std::int64_t block_of(std::int64_t cell, std::int64_t side) {
  return (cell >= 0 ? cell : cell - side + 1) / side;
}

}  // namespace

void require_few_cells(double wide_m, double high_m, double cell_m) {
  const double cells = (wide_m / cell_m) * (high_m / cell_m);
  if (cells <= kMostCells) return;
  const double enough_m = std::sqrt(wide_m * high_m / kMostCells);
  const double decade = std::pow(10.0, std::floor(std::log10(enough_m)));
  throw bad_input(fmt::format(
      "cells of {:g} m over {:.0f} m by {:.0f} m would be {:.2g}; at most {:g} are possible: give --cell "
      "{:g} or more",
      cell_m, wide_m, high_m, cells, kMostCells, std::ceil(10 * enough_m / decade) * decade / 10));
}

LaidCells::Block& LaidCells::block_at(CellIndex index) {
  if (last_block_ != nullptr && index == last_) return *last_block_;
  std::unique_ptr<Block>& block = blocks_[index];
  if (!block) {
    const bool first = high_column_ < low_column_;
    low_column_ = first ? index.column : std::min(low_column_, index.column);
    high_column_ = first ? index.column : std::max(high_column_, index.column);
    low_row_ = first ? index.row : std::min(low_row_, index.row);
    high_row_ = first ? index.row : std::max(high_row_, index.row);
    const double side_m = static_cast<double>(kSide) * cell_m_;
    // The blocks at the rim may be all but empty.
    require_few_cells(static_cast<double>(std::max<std::int64_t>(1, high_column_ - low_column_ - 1)) * side_m,
                      static_cast<double>(std::max<std::int64_t>(1, high_row_ - low_row_ - 1)) * side_m,
                      cell_m_);
    block = std::make_unique<Block>();
    block->fill(0);
  }
  last_ = index;
  last_block_ = block.get();
  return *block;
}

void LaidCells::add(std::span<const CellPart> parts) {
  for (const CellPart& part : parts) {
    const CellIndex index{block_of(part.column, kSide), block_of(part.row, kSide)};
    const std::int64_t column = part.column - index.column * kSide, row = part.row - index.row * kSide;
    block_at(index)[static_cast<std::size_t>(row * kSide + column)] += part.amount;
  }
}

CellGrid LaidCells::grid(const Box& box, const Box& reach) const {
  std::int64_t low_column = INT64_MAX, high_column = INT64_MIN, low_row = INT64_MAX, high_row = INT64_MIN;
  for (const auto& [index, block] : blocks_)
    for (std::int64_t i = 0; i < kSide * kSide; ++i) {
      if ((*block)[static_cast<std::size_t>(i)] == 0) continue;
      const std::int64_t column = index.column * kSide + i % kSide, row = index.row * kSide + i / kSide;
      low_column = std::min(low_column, column);
      high_column = std::max(high_column, column);
      low_row = std::min(low_row, row);
      high_row = std::max(high_row, row);
    }
  Box all = box;
  if (low_column <= high_column) {
    all.extend(Point{static_cast<double>(low_column) * cell_m_, static_cast<double>(low_row) * cell_m_});
    all.extend(
        Point{static_cast<double>(high_column + 1) * cell_m_, static_cast<double>(high_row + 1) * cell_m_});
  }
  if (all.empty()) all = {0, 0, cell_m_, cell_m_};
  all = {all.min_x + std::min(0.0, reach.min_x), all.min_y + std::min(0.0, reach.min_y),
         all.max_x + std::max(0.0, reach.max_x), all.max_y + std::max(0.0, reach.max_y)};
  require_few_cells(all.width(), all.height(), cell_m_);
  // A corner on a line of the grid, but for rounding, opens no cell beyond it.
  constexpr double kRounding = 1e-6;
  const double left = std::floor(all.min_x / cell_m_ + kRounding),
               right = std::ceil(all.max_x / cell_m_ - kRounding);
  const double bottom = std::floor(all.min_y / cell_m_ + kRounding),
               top = std::ceil(all.max_y / cell_m_ - kRounding);
  return {{left * cell_m_, bottom * cell_m_},
          cell_m_,
          std::max(1, static_cast<int>(right - left)),
          std::max(1, static_cast<int>(top - bottom))};
}

std::vector<double> LaidCells::amounts(const CellGrid& grid) const {
  std::vector<double> out(grid.size(), 0.0);
  const auto left = static_cast<std::int64_t>(std::llround(grid.low.x / cell_m_));
  const auto bottom = static_cast<std::int64_t>(std::llround(grid.low.y / cell_m_));
  for (const auto& [index, block] : blocks_)
    for (std::int64_t i = 0; i < kSide * kSide; ++i) {
      const double amount = (*block)[static_cast<std::size_t>(i)];
      if (amount == 0) continue;
      const std::int64_t column = index.column * kSide + i % kSide - left;
      const std::int64_t row = index.row * kSide + i / kSide - bottom;
      out[grid.index(static_cast<int>(column), static_cast<int>(row))] = amount;
    }
  return out;
}

}  // namespace tramline::coverage
