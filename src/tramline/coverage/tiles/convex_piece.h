#pragma once
// Convex polygons on the grid of the plane: the parts of quads.

#include <cstdint>
#include <vector>

#include "tramline/coverage/tiles/grid_point.h"

namespace tramline::coverage {

/// A directed line; inside is left of it.
struct GridLine {
  GridPoint at;
  double nx = 0;  ///< unit normal to the left
  double ny = 0;

  /// Distance of a point, positive inside, units. To 2^-18 units for points within 2^34.
  double inside(GridPoint p) const {
    return nx * static_cast<double>(p.x - at.x) + ny * static_cast<double>(p.y - at.y);
  }
  GridLine turned() const { return {at, -nx, -ny}; }
};

/// Precondition: two different points.
GridLine line_through(GridPoint from, GridPoint to);

/// A convex polygon, counter-clockwise. Every side keeps the line that it lies on: corners are rounded, and
/// the line through two corners that all but coincide may point anywhere.
struct ConvexPiece {
  struct Side {
    GridPoint from;
    GridLine line;
  };
  std::vector<Side> sides;

  bool empty() const { return sides.size() < 3; }
};

/// Precondition: convex, counter-clockwise.
ConvexPiece piece_of(const std::vector<GridPoint>& corners);

/// Twice the area, square units.
Int128 twice_area(const ConvexPiece& piece);

/// The parts left (inside) and right (outside) of a line; a part no wider than kOnLine is empty.
void split(const ConvexPiece& piece, const GridLine& line, ConvexPiece& inside, ConvexPiece& outside);

}  // namespace tramline::coverage
