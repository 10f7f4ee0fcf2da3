#pragma once
// The joins that a tree is likely to have: those of near nodes.

#include <cstddef>
#include <queue>
#include <vector>

#include "tramline/route/certificate/node_join.h"
#include "tramline/route/search/neighbours.h"

namespace tramline::order {

/// Joins of near nodes that join all members, and their least spanning trees under changing prices.
class NearJoins {
 public:
  /// Of each node the cheapest joins among those with the nodes nearest by least(). O(nodes²) calls of that.
  explicit NearJoins(const ConnectionBounds& bounds);
  /// Of each node the joins with those that are known to be near; of nodes beyond these none.
  NearJoins(const ConnectionBounds& bounds, const Neighbours& near);

  const std::vector<NodeJoin>& joins() const { return joins_; }
  void add(const std::vector<NodeJoin>& joins);

  /// O(joins + n log n).
  const JoinTree& tree(const std::vector<double>& prices_s);

 private:
  /// A join as one of its members sees it.
  struct Arm {
    std::size_t other = 0;  ///< member
    std::size_t join = 0;
    NodeJoin nodes;
  };
  struct Reached {
    double cost_s = 0;
    std::size_t member = 0, join = 0;
    friend bool operator>(const Reached& a, const Reached& b) {
      return a.cost_s != b.cost_s ? a.cost_s > b.cost_s : a.join > b.join;
    }
  };
  void join_all();
  std::vector<NodeJoin> ways_between_sets(JoinedSets& sets) const;
  void index();
  void reach_from(std::size_t member, const std::vector<double>& prices_s);

  const ConnectionBounds& bounds_;
  std::vector<NodeJoin> joins_;
  std::vector<std::size_t> first_;  ///< by member: where its arms begin
  std::vector<Arm> arms_;           ///< by member
  // Of the tree that grows.
  std::vector<double> key_s_;  ///< by member not in the tree: the cheapest join to it
  std::vector<Reached> heap_;
  JoinTree tree_;
};

}  // namespace tramline::order
