#pragma once
// An index of boxes that finds those that meet a given one.

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "tramline/geometry/polygon/region.h"

namespace tramline {

/// Boxes sorted into the square cells of a grid. Built once, and safe to read from any number of threads.
class BoxGrid {
 public:
  BoxGrid() = default;
  /// About one cell for each box; boxes must not be empty. O(n + cells the boxes touch).
  explicit BoxGrid(const std::vector<Box>& boxes);

  /// Calls `visit(index)` once for every box that meets `window`, by cell and then by index.
  template <class Visit>
  void each_meeting(const Box& window, Visit visit) const {
    if (boxes_.empty() || !intersects(window, bounds_)) return;
    const Cells cells = cells_of(window);
    for (int row = cells.first_row; row <= cells.last_row; ++row)
      for (int column = cells.first_column; column <= cells.last_column; ++column)
        visit_cell(row, column, cells, window, visit);
  }

  const Box& bounds() const { return bounds_; }
  double cell_m() const { return cell_m_; }

 private:
  struct Cells {
    int first_column, last_column, first_row, last_row;
  };

  int column_of(double x) const { return cell_index((x - bounds_.min_x) / cell_m_, columns_); }
  int row_of(double y) const { return cell_index((y - bounds_.min_y) / cell_m_, rows_); }
  static int cell_index(double cell, int count) {
    return static_cast<int>(std::clamp(std::floor(cell), 0.0, static_cast<double>(count - 1)));
  }
  Cells cells_of(const Box& box) const {
    return {column_of(box.min_x), column_of(box.max_x), row_of(box.min_y), row_of(box.max_y)};
  }

  /// A box that lies in several of the cells is visited in the lowest of them only.
  template <class Visit>
  void visit_cell(int row, int column, const Cells& asked, const Box& window, Visit& visit) const {
    const auto cell =
        static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) + static_cast<std::size_t>(column);
    for (std::size_t i = begins_[cell]; i < begins_[cell + 1]; ++i) {
      const Box& box = boxes_[members_[i]];
      if (!intersects(box, window)) continue;
      if (std::max(column_of(box.min_x), asked.first_column) != column) continue;
      if (std::max(row_of(box.min_y), asked.first_row) != row) continue;
      visit(members_[i]);
    }
  }

  std::vector<Box> boxes_;
  Box bounds_;
  double cell_m_ = 1;
  int columns_ = 1;
  int rows_ = 1;
  std::vector<std::size_t> begins_;   ///< of each cell's members
  std::vector<std::size_t> members_;  ///< indices of boxes
};

}  // namespace tramline
