#pragma once
// Directed edges, of which those walked both ways cancel.

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

  /// Calls `visit(from, to)` for every edge that is left, in the order in which they came first; twice for
  /// what was walked twice more one way than the other.
  template <class Visit>
  void each_left(Visit visit) const {
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
  std::vector<std::uint32_t> table_;  ///< numbers of edges by hash, plus 1; 0: free
};

}  // namespace tramline::coverage
