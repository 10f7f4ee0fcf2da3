#pragma once
// A grid of square cells over the plane.

#include <cstddef>

#include "tramline/geometry/polygon/region.h"

namespace tramline {

/// Rows from the south, columns from the west. Frame: local metres.
struct CellGrid {
  Point low;  ///< south-west corner
  double cell_m = 1;
  int columns = 0;
  int rows = 0;

  std::size_t size() const { return static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows); }
  std::size_t index(int column, int row) const {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns) +
           static_cast<std::size_t>(column);
  }
  double cell_area_m2() const { return cell_m * cell_m; }
  Box box() const { return {low.x, low.y, low.x + columns * cell_m, low.y + rows * cell_m}; }
};

/// The most cells of a grid; larger ones are refused. At this size a map and its working memory take some 400
/// MB.
inline constexpr double kMostCells = 1e7;

}  // namespace tramline
