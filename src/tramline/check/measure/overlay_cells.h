#pragma once
// Overlay of shapes: the areas that any number of shapes have in common, cell by cell.

#include <cstddef>
#include <functional>
#include <vector>

#include "tramline/geometry/polygon/region.h"

namespace tramline::check {

/// A shape that covers a cell, and how many of its polygons do: 1, or more where they overlap.
struct Cover {
  std::size_t shape = 0;
  int times = 0;
};

/// A trapezium that no edge crosses.
struct OverlayCell {
  double area_m2 = 0;
  Point middle;
  const std::vector<Cover>& covers;  ///< all shapes that contain it, ascending
};

/// The edges of any number of shapes, each of any number of polygons, which may overlap.
class OverlayEdges {
 public:
  /// Outer rings count 1 inside and holes −1, whichever way they run.
  void add(const Polygon& polygon, std::size_t shape);
  void add(const Region& region, std::size_t shape);

  /// A stretch of an edge along which y rises.
  struct Edge {
    Point low;
    Point high;
    std::size_t shape = 0;
    int change = 0;  ///< change of the shape's count across the edge towards growing x
  };
  const std::vector<Edge>& edges() const { return edges_; }
  const Box& bounds() const { return bounds_; }

 private:
  void add_ring(const Ring& ring, int sign, std::size_t shape);

  std::vector<Edge> edges_;
  Box bounds_;
};

/// Visits all land that lies in any shape, cell by cell, without overlays or grids: the plane is halved until
/// a window holds few edges, and the window is cut into slabs between the heights where edges begin, end and
/// cross. So the areas of cells add up to those of the shapes but for rounding, 1e-16 of the window for each
/// cell. O(n log n) for n edges of which only a few cross any one spot.
void each_cell(const OverlayEdges& overlay, const std::function<void(const OverlayCell&)>& visit);

}  // namespace tramline::check
