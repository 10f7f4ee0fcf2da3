#include "tramline/route/certificate/shortcuts.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace tramline::order {
namespace {

struct TreeEdge {
  std::size_t member = 0;
  double cost_s = 0;
};

class ShortcutSearch {
 public:
  ShortcutSearch(const JoinTree& tree, const std::vector<double>& prices_s, const ConnectionBounds& bounds)
      : prices_s_(prices_s), bounds_(bounds), edges_(bounds.members()), most_s_(edges_.size()) {
    for (const NodeJoin& join : tree.joins) {
      const std::size_t a = bounds.member_of(join.a), b = bounds.member_of(join.b);
      edges_[a].push_back({b, priced(join, prices_s)});
      edges_[b].push_back({a, priced(join, prices_s)});
    }
  }

  std::vector<NodeJoin> run() {
    for (std::size_t member = 0; member < edges_.size(); ++member) {
      find_most_expensive(member);
      for (std::size_t other = 0; other < member; ++other) look_at(member, other);
    }
    return std::move(found_);
  }

 private:
  /// The most expensive join on the way to every member in the tree.
  void find_most_expensive(std::size_t from) {
    most_s_[from] = -std::numeric_limits<double>::max();
    stack_.assign(1, {from, from});
    while (!stack_.empty()) {
      const auto [member, before] = stack_.back();
      stack_.pop_back();
      for (const TreeEdge& edge : edges_[member]) {
        if (edge.member == before) continue;
        most_s_[edge.member] = std::max(most_s_[member], edge.cost_s);
        stack_.emplace_back(edge.member, member);
      }
    }
  }

  void look_at(std::size_t member, std::size_t other) {
    double least_s = most_s_[other];
    NodeJoin best;
    for (const std::size_t a : bounds_.nodes_of(member))
      for (const std::size_t b : bounds_.nodes_of(other)) {
        if (!bounds_.may_join(a, b)) continue;
        const double price_s = prices_s_[a] + prices_s_[b];
        if (bounds_.least(a, b) + price_s >= least_s) continue;
        const NodeJoin join{a, b, bounds_.between(a, b)};
        if (priced(join, prices_s_) >= least_s) continue;
        least_s = priced(join, prices_s_);
        best = join;
      }
    if (best.a != best.b) found_.push_back(best);
  }

  const std::vector<double>& prices_s_;
  const ConnectionBounds& bounds_;
  std::vector<std::vector<TreeEdge>> edges_;  ///< by member
  std::vector<double> most_s_;                ///< by member
  std::vector<std::pair<std::size_t, std::size_t>> stack_;
  std::vector<NodeJoin> found_;
};

}  // namespace

std::vector<NodeJoin> shortcuts(const JoinTree& tree, const std::vector<double>& prices_s,
                                const ConnectionBounds& bounds) {
  return ShortcutSearch(tree, prices_s, bounds).run();
}

}  // namespace tramline::order
