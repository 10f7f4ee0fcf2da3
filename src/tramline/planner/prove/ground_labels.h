#pragma once
// The ground as pixels, each with the price cells that are near it.

#include <cstddef>
#include <cstdint>
#include <vector>

#include "tramline/geometry/polygon/region.h"
#include "tramline/geometry/strip/track_frame.h"

namespace tramline {

/// Square cells of the ground, side by side in the plane turned by `frame`.
struct PriceGrid {
  TrackFrame frame;
  Point corner;       ///< of column 0 and row 0, turned plane
  double side_m = 1;  ///< > 0
  int columns = 0, rows = 0;

  struct Cell {
    int column = 0, row = 0;
    double inside_m2 = 0;  ///< > 0: land in it
  };
  std::vector<Cell> cells;
  std::vector<int> index;  ///< of the cell in a column and row, column by column; −1: no land there

  /// Where in `index` a column and row is.
  std::size_t place(int column, int row) const {
    return static_cast<std::size_t>(column) * static_cast<std::size_t>(rows) + static_cast<std::size_t>(row);
  }

  Box box(const Cell& cell) const {
    const Point low = corner + Point{cell.column * side_m, cell.row * side_m};
    return {low.x, low.y, low.x + side_m, low.y + side_m};
  }
};

/// The smallest cells of which at most `most` have any of the land, none smaller than `least_m`; columns and
/// rows reach over all of the ground. O(most · n) for n corners.
PriceGrid price_grid(const Region& land, const Region& ground, Direction along, int most, double least_m);

/// What one square metre somewhere is worth to a piece that works it, at most.
class PixelWorth {
 public:
  /// By set of labels.
  std::vector<double> worth;
  std::vector<int> label;  ///< the cell it comes from; or kOutside, kPassable
};

/// For every place the cells that have land within a distance of it.
class GroundLabels {
 public:
  static constexpr int kOutside = -1, kPassable = -2;

  /// `land` and `passable` in the plane of the grid; `reach_m` ≥ 0; pixels of at most `pixel_m`.
  GroundLabels(const PriceGrid& grid, const Region& land, const Region& passable, double reach_m,
               double pixel_m);

  /// The highest price within reach, of each set of labels: −`overlap` outside the land, 0 on passable land.
  PixelWorth worth(const std::vector<double>& prices, double overlap) const;

  /// The set of a place of the plane of the grid.
  std::int32_t set_at(Point at) const {
    const double x = (at.x - corner_.x) * per_m_, y = (at.y - corner_.y) * per_m_;
    if (!(x >= 0 && y >= 0 && x < columns_ && y < rows_)) return 0;
    return sets_[static_cast<std::size_t>(x) * static_cast<std::size_t>(rows_) + static_cast<std::size_t>(y)];
  }
  /// All places beyond it have no land within reach.
  Box box() const {
    return {corner_.x, corner_.y, corner_.x + columns_ / per_m_, corner_.y + rows_ / per_m_};
  }

 private:
  void mark(const Region& region, std::vector<std::uint8_t>& pixels, std::uint8_t bit) const;
  void gather(const PriceGrid& grid, const std::vector<std::uint8_t>& pixels, double reach_m, int margin,
              int by_side);

  Point corner_;
  double per_m_ = 1;
  int columns_ = 0, rows_ = 0;
  std::vector<std::int32_t> sets_;           ///< by pixel, column by column
  std::vector<std::vector<int>> labels_of_;  ///< by set; 0: nothing within reach
};

}  // namespace tramline
