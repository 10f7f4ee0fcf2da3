#pragma once
// Which ends of lines are near which: the only ones that searches look at.

#include <cstddef>
#include <functional>
#include <vector>

namespace tramline::order {

/// For each node (an end of a line) other nodes near it, nearest first.
using Neighbours = std::vector<std::vector<std::size_t>>;

/// The time between two nodes, s, or something like it. Symmetric.
using PairCost = std::function<double(std::size_t, std::size_t)>;

struct NeighbourCounts {
  std::size_t looked_at = 30;  ///< of each node those nearest by the estimate
  std::size_t kept = 8;        ///< of these those nearest by the cost
};

/// The neighbours of `nodes` nodes. Of each node the first `looked_at` others by the estimate are looked at,
/// and of these the cheapest are kept; among equals the lower number. Nodes whose numbers halved are equal
/// are never neighbours: the ends of one line. O(nodes²) estimates, O(nodes·looked_at) costs.
Neighbours neighbours_of(std::size_t nodes, const PairCost& estimate, const PairCost& cost,
                         const NeighbourCounts& counts = {});

/// The same for one node where those looked at are known: the cheapest of them, `kept` at the most.
std::vector<std::size_t> cheapest_of(std::size_t node, const std::vector<std::size_t>& looked_at,
                                     const PairCost& cost, std::size_t kept = NeighbourCounts{}.kept);

}  // namespace tramline::order
