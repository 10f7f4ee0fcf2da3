#pragma once
// A spatial index of the edges of a region.

#include <vector>

#include "tramline/geometry/index/box_grid.h"
#include "tramline/geometry/polygon/region.h"

namespace tramline {

/// The edges of a region, indexed for the intersection with paths. Rings oriented: outer counter-clockwise,
/// holes clockwise.
class EdgeIndex {
 public:
  explicit EdgeIndex(const Region& oriented);

  struct Edge {
    Point from;
    Point to;
  };
  const std::vector<Edge>& edges() const { return edges_; }
  const BoxGrid& grid() const { return grid_; }
  bool contains(Point p) const;  ///< even-odd over all edges. O(n)

 private:
  std::vector<Edge> edges_;
  BoxGrid grid_;
};

}  // namespace tramline
