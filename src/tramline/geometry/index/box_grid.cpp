#include "tramline/geometry/index/box_grid.h"

#include "tramline/geometry/tolerances.h"

namespace tramline {

BoxGrid::BoxGrid(const std::vector<Box>& boxes) : boxes_(boxes) {
  if (boxes_.empty()) return;
  for (const Box& box : boxes_) bounds_.extend(box);
  const double longer = std::max({bounds_.width(), bounds_.height(), kLeastGridSide_m});
  const double shorter = std::max(std::min(bounds_.width(), bounds_.height()), kFlattestGrid_share * longer);
  cell_m_ = std::max(std::sqrt(longer * shorter / static_cast<double>(boxes_.size())),
                     kFlattestGrid_share * longer);
  columns_ = static_cast<int>(bounds_.width() / cell_m_) + 1;
  rows_ = static_cast<int>(bounds_.height() / cell_m_) + 1;

  const auto each_cell = [this](const Box& box, auto act) {
    const Cells cells = cells_of(box);
    for (int row = cells.first_row; row <= cells.last_row; ++row)
      for (int column = cells.first_column; column <= cells.last_column; ++column)
        act(static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) +
            static_cast<std::size_t>(column));
  };
  begins_.assign(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_) + 1, 0);
  for (const Box& box : boxes_) each_cell(box, [this](std::size_t cell) { ++begins_[cell + 1]; });
  for (std::size_t i = 1; i < begins_.size(); ++i) begins_[i] += begins_[i - 1];
  members_.resize(begins_.back());
  std::vector<std::size_t> next(begins_.begin(), begins_.end() - 1);
  for (std::size_t i = 0; i < boxes_.size(); ++i)
    each_cell(boxes_[i], [&](std::size_t cell) { members_[next[cell]++] = i; });
}

}  // namespace tramline
