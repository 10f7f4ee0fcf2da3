#include "tramline/route/certificate/near_joins.h"

#include <algorithm>
#include <cassert>
#include <functional>
#include <limits>

namespace tramline::order {
namespace {

constexpr NeighbourCounts kNearNodes{24, 8};

/// A ring is near most ends: only those that are nearest to it count, or all others would lose neighbours.
bool are_apart(const ConnectionBounds& bounds, std::size_t a, std::size_t b) {
  return !bounds.may_join(a, b) || (bounds.is_ring(b) && !bounds.is_ring(a));
}

Neighbours near_nodes(const ConnectionBounds& bounds) {
  const double never = std::numeric_limits<double>::max();
  return neighbours_of(
      bounds.nodes(),
      [&](std::size_t a, std::size_t b) { return are_apart(bounds, a, b) ? never : bounds.least(a, b); },
      [&](std::size_t a, std::size_t b) { return are_apart(bounds, a, b) ? never : bounds.between(a, b); },
      kNearNodes);
}

}  // namespace

NearJoins::NearJoins(const ConnectionBounds& bounds) : NearJoins(bounds, near_nodes(bounds)) {}

NearJoins::NearJoins(const ConnectionBounds& bounds, const Neighbours& near) : bounds_(bounds) {
  assert(near.size() <= bounds.nodes());
  for (std::size_t a = 0; a < near.size(); ++a)
    for (const std::size_t b : near[a]) {
      if (are_apart(bounds, a, b)) continue;
      const bool both = std::find(near[b].begin(), near[b].end(), a) != near[b].end();
      if (a < b || !both) joins_.push_back({a, b, bounds.between(a, b)});
    }
  join_all();
  index();
}

void NearJoins::add(const std::vector<NodeJoin>& joins) {
  joins_.insert(joins_.end(), joins.begin(), joins.end());
  index();
}

/// Adds joins until all members are in one set (Borůvka 1926, by least()).
void NearJoins::join_all() {
  JoinedSets sets(bounds_.members());
  std::size_t count = bounds_.members();
  const auto join = [&](const NodeJoin& made) {
    const bool joined = sets.join(bounds_.member_of(made.a), bounds_.member_of(made.b));
    if (joined) --count;
    return joined;
  };
  for (const NodeJoin& made : joins_) join(made);
  while (count > 1)
    for (NodeJoin& way : ways_between_sets(sets))
      if (join(way)) {
        way.cost_s = bounds_.between(way.a, way.b);
        joins_.push_back(way);
      }
}

/// From each set the join to another set that is the least by least().
std::vector<NodeJoin> NearJoins::ways_between_sets(JoinedSets& sets) const {
  std::vector<NodeJoin> best(bounds_.members(), {0, 0, std::numeric_limits<double>::max()});
  for (std::size_t a = 0; a < bounds_.nodes(); ++a)
    for (std::size_t b = 0; b < a; ++b) {
      const std::size_t set_a = sets.set_of(bounds_.member_of(a)), set_b = sets.set_of(bounds_.member_of(b));
      if (set_a == set_b || !bounds_.may_join(a, b)) continue;
      const NodeJoin way{a, b, bounds_.least(a, b)};
      for (const std::size_t set : {set_a, set_b})
        if (way.cost_s < best[set].cost_s) best[set] = way;
    }
  std::erase_if(best, [](const NodeJoin& way) { return way.a == way.b; });
  return best;
}

void NearJoins::index() {
  const auto member = [&](std::size_t node) { return bounds_.member_of(node); };
  first_.assign(bounds_.members() + 1, 0);
  for (const NodeJoin& join : joins_)
    for (const std::size_t node : {join.a, join.b}) ++first_[member(node) + 1];
  for (std::size_t i = 1; i < first_.size(); ++i) first_[i] += first_[i - 1];
  arms_.resize(2 * joins_.size());
  std::vector<std::size_t> next(first_);
  for (std::size_t i = 0; i < joins_.size(); ++i) {
    const std::size_t a = member(joins_[i].a), b = member(joins_[i].b);
    arms_[next[a]++] = {b, i, joins_[i]};
    arms_[next[b]++] = {a, i, joins_[i]};
  }
}

const JoinTree& NearJoins::tree(const std::vector<double>& prices_s) {
  tree_.joins.clear();
  tree_.sum_s = 0;
  key_s_.assign(bounds_.members(), std::numeric_limits<double>::max());
  heap_.clear();
  reach_from(0, prices_s);
  while (!heap_.empty()) {
    std::pop_heap(heap_.begin(), heap_.end(), std::greater<>());
    const Reached reached = heap_.back();
    heap_.pop_back();
    if (reached.cost_s != key_s_[reached.member]) continue;
    tree_.joins.push_back(joins_[reached.join]);
    tree_.sum_s += reached.cost_s;
    reach_from(reached.member, prices_s);
  }
  return tree_;
}

/// The member is in the tree from now on.
void NearJoins::reach_from(std::size_t member, const std::vector<double>& prices_s) {
  key_s_[member] = -std::numeric_limits<double>::max();
  for (std::size_t i = first_[member]; i < first_[member + 1]; ++i) {
    const Arm& arm = arms_[i];
    const double cost_s = priced(arm.nodes, prices_s);
    if (cost_s >= key_s_[arm.other]) continue;
    key_s_[arm.other] = cost_s;
    heap_.push_back({cost_s, arm.other, arm.join});
    std::push_heap(heap_.begin(), heap_.end(), std::greater<>());
  }
}

}  // namespace tramline::order
