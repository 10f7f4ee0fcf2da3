#pragma once
// Shapes laid over one another: which ground do they have in common, and how much is it?

#include <cstddef>
#include <functional>
#include <vector>

#include "tramline/geometry/polygon/region.h"

namespace tramline::check {

/// A shape over a cell, and how often its polygons cover it: 1, or more where they lie over one another.
struct Cover {
  std::size_t shape = 0;
  int times = 0;
};

/// A trapezium that no edge runs through.
struct GroundCell {
  double area_m2 = 0;
  Point middle;
  const std::vector<Cover>& covers;  ///< all shapes that hold it, ascending
};

/// Edges of any number of shapes, each of any number of polygons, which may overlap.
class GroundEdges {
 public:
  /// Outer rings count 1 inside and holes −1, whichever way they run.
  void add(const Polygon& polygon, std::size_t shape);
  void add(const Region& region, std::size_t shape);

  /// A stretch of an edge along which y rises.
  struct Edge {
    Point low;
    Point high;
    std::size_t shape = 0;
    int change = 0;  ///< of the shape's count, on the way across the edge towards growing x
  };
  const std::vector<Edge>& edges() const { return edges_; }
  const Box& bounds() const { return bounds_; }

 private:
  void add_ring(const Ring& ring, int sign, std::size_t shape);

  std::vector<Edge> edges_;
  Box bounds_;
};

/// Visits all ground that lies in any shape, cell by cell. Neither overlays nor grids: the plane is halved
/// until a window holds few edges, and there cut into slabs between the heights where edges begin, end and
/// cross. So the areas of cells add up to those of the shapes but for rounding, 1e-16 of the window for each
/// cell. O(n log n) for n edges while only a few lie at any one place.
void each_cell(const GroundEdges& ground, const std::function<void(const GroundCell&)>& visit);

}  // namespace tramline::check
