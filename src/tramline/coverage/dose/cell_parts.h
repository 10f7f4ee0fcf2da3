#pragma once
// A convex polygon with a linearly varying density, cut at the lines of a grid.

#include <cstdint>
#include <vector>

#include "tramline/coverage/dose/convex_parts.h"

namespace tramline::coverage {

/// A linear density: at + dot(slope, p).
struct EvenDensity {
  double at = 1;
  Point slope;

  double operator()(Point p) const { return at + dot(slope, p); }
};

/// The integral of the density over a polygon. O(corners).
double integral(const SmallPolygon& polygon, const EvenDensity& density);

/// The part of the integral in the cell [column, column + 1) × [row, row + 1), in cells of the grid through
/// the origin.
struct CellPart {
  std::int64_t column = 0;
  std::int64_t row = 0;
  double amount = 0;
};

/// Appends the integral of the density over the polygon's part in every cell it overlaps: exact up to
/// rounding; the sum of the parts is the whole. O(cells). Precondition: at most eight corners.
void append_cell_parts(const SmallPolygon& polygon, const EvenDensity& density, double cell_m,
                       std::vector<CellPart>& out);

}  // namespace tramline::coverage
