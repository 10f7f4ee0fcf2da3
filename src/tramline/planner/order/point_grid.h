#pragma once
// Which of many places are nearest?

#include <cstddef>
#include <vector>

#include "tramline/geometry/polygon/region.h"

namespace tramline::order {

/// Places sorted into the square cells of a grid, from which they can be taken out.
class PlaceGrid {
 public:
  /// About one cell for two places. O(n)
  explicit PlaceGrid(const std::vector<Point>& places);

  void remove(std::size_t place);

  /// The `most` places nearest to p that are not taken out, nearest first; among equals the one with the
  /// lower number. O(cells within the reach of the answer + most·log most)
  std::vector<std::size_t> nearest(Point p, std::size_t most) const;

 private:
  struct Found {
    double reach_m2 = 0;  ///< square of the distance
    std::size_t place = 0;
  };
  int column_of(Point p) const;
  int row_of(Point p) const;
  void add_cell(int column, int row, Point p, std::vector<Found>& found) const;

  std::vector<Point> places_;
  Box box_;
  double cell_m_ = 1;
  int columns_ = 1;
  int rows_ = 1;
  std::vector<std::vector<std::size_t>> cells_;
};

}  // namespace tramline::order
