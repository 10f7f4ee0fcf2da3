#include "tramline/route/search/neighbours.h"

#include <algorithm>
#include <utility>

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
  Neighbours looked_at(nodes);
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
    for (const RatedNode& rated : nearest) looked_at[node].push_back(rated.node);
  }
  for (std::size_t node = 0; node < nodes; ++node)
    looked_at[node] = cheapest_of(node, looked_at[node], cost, counts.kept);
  return looked_at;
}

std::vector<std::size_t> cheapest_of(std::size_t node, const std::vector<std::size_t>& looked_at,
                                     const PairCost& cost, std::size_t kept) {
  std::vector<RatedNode> rated;
  for (const std::size_t other : looked_at) rated.push_back({cost(node, other), other});
  std::sort(rated.begin(), rated.end());
  rated.resize(std::min(rated.size(), kept));
  std::vector<std::size_t> out;
  for (const RatedNode& one : rated) out.push_back(one.node);
  return out;
}

}  // namespace tramline::order
