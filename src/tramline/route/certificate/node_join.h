#pragma once
// Connections between nodes, and the trees they form over lines, gates and rings.

#include <cstddef>
#include <numeric>
#include <vector>

#include "tramline/route/certificate/connection_bounds.h"

namespace tramline::order {

/// Two nodes that a connection may join, and the least time of it, s.
struct NodeJoin {
  std::size_t a = 0, b = 0;
  double cost_s = 0;
};

inline double priced(const NodeJoin& join, const std::vector<double>& prices_s) {
  return join.cost_s + prices_s[join.a] + prices_s[join.b];
}

/// The joins of a tree over all members, and the sum of their priced times, s.
struct JoinTree {
  std::vector<NodeJoin> joins;
  double sum_s = 0;
};

/// Sets of members that joins have made one.
class JoinedSets {
 public:
  explicit JoinedSets(std::size_t members) : parent_(members) {
    std::iota(parent_.begin(), parent_.end(), 0);
  }
  std::size_t set_of(std::size_t member) {
    while (parent_[member] != member) member = parent_[member] = parent_[parent_[member]];
    return member;
  }
  /// False where both are in one set already.
  bool join(std::size_t a, std::size_t b) {
    a = set_of(a);
    b = set_of(b);
    parent_[a] = b;
    return a != b;
  }

 private:
  std::vector<std::size_t> parent_;
};

/// The least spanning tree of these joins under prices (Kruskal 1956). O(n log n). Precondition: they join
/// all members.
JoinTree least_tree(std::vector<NodeJoin> joins, const std::vector<double>& prices_s,
                    const ConnectionBounds& bounds);

}  // namespace tramline::order
