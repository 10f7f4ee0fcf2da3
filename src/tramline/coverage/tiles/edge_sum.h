#pragma once
// A sum of directed edges in which opposite edges cancel.

#include <cstddef>
#include <cstdint>
#include <vector>

#include "tramline/coverage/tiles/grid_point.h"

namespace tramline::coverage {

/// Adds up edges. O(1) each.
class EdgeSum {
 public:
  explicit EdgeSum(std::size_t expected);

  void add(TilePoint from, TilePoint to);

  /// Calls `visit(from, to)` for every edge that remains, in the order of first addition; twice for an edge
  /// added twice more in one direction than in the other.
  template <class Visit>
  void each_remaining(Visit visit) const {
    for (const Edge& edge : edges_) {
      for (int i = 0; i < edge.net; ++i) visit(edge.least, edge.most);
      for (int i = 0; i < -edge.net; ++i) visit(edge.most, edge.least);
    }
  }

 private:
  struct Edge {
    TilePoint least;
    TilePoint most;
    int net = 0;
  };

  std::vector<Edge> edges_;
  std::vector<std::uint32_t> table_;  ///< indices of edges by hash, plus 1; 0: free
};

}  // namespace tramline::coverage
