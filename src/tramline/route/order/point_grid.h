#pragma once
// A grid for finding the nearest of many points.

#include <cstddef>
#include <vector>

#include "tramline/geometry/polygon/region.h"

namespace tramline::order {

/// Points sorted into the square cells of a grid, from which they can be removed.
class PointGrid {
 public:
  /// Uses about one cell for two points. O(n)
  explicit PointGrid(const std::vector<Point>& points);

  void remove(std::size_t index);

  /// Indices of up to `most` points nearest to p that have not been removed, nearest first; among equals the
  /// lower index. O(cells within the reach of the answer + most·log most)
  std::vector<std::size_t> nearest(Point p, std::size_t most) const;

  /// Whether a point that has not been removed is no farther from p than this. O(cells within the distance)
  bool has_within(Point p, double distance_m) const;

 private:
  struct Found {
    double reach_m2 = 0;  ///< square of the distance
    std::size_t index = 0;
  };
  int column_of(Point p) const;
  int row_of(Point p) const;
  std::size_t place(int column, int row) const;  ///< of a cell in `cells_`
  void add_cell(int column, int row, Point p, std::vector<Found>& found) const;

  std::vector<Point> points_;
  Box box_;
  double cell_m_ = 1;
  int columns_ = 1;
  int rows_ = 1;
  std::vector<std::vector<std::size_t>> cells_;
};

}  // namespace tramline::order
