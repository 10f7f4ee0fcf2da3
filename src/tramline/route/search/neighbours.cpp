#include "tramline/route/search/neighbours.h"

#include <algorithm>

namespace tramline::order {
namespace {

struct RatedNode {
  double cost = 0;
  std::size_t node = 0;
  friend bool operator<(const RatedNode& a, const RatedNode& b) {
    return a.cost != b.cost ? a.cost < b.cost : a.node < b.node;
  }
};

}  // namespace

Neighbours neighbours_of(std::size_t nodes, const PairCost& estimate, const PairCost& cost,
                         const NeighbourCounts& counts) {
  Neighbours out(nodes);
  std::vector<RatedNode> nearest;  // a heap, the farthest first
  for (std::size_t node = 0; node < nodes; ++node) {
    nearest.clear();
    for (std::size_t other = 0; other < nodes; ++other) {
      if (other / 2 == node / 2) continue;
      const RatedNode rated{estimate(node, other), other};
      if (nearest.size() == counts.looked_at) {
        if (nearest.empty() || !(rated < nearest.front())) continue;
        std::pop_heap(nearest.begin(), nearest.end());
        nearest.back() = rated;
      } else {
        nearest.push_back(rated);
      }
      std::push_heap(nearest.begin(), nearest.end());
    }
    for (RatedNode& rated : nearest) rated.cost = cost(node, rated.node);
    std::sort(nearest.begin(), nearest.end());
    nearest.resize(std::min(nearest.size(), counts.kept));
    for (const RatedNode& rated : nearest) out[node].push_back(rated.node);
  }
  return out;
}

}  // namespace tramline::order
