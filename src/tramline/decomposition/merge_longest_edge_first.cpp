#include "tramline/decomposition/merge_longest_edge_first.h"

#include <algorithm>
#include <queue>
#include <tuple>

namespace tramline {
namespace {

struct Pair {
  double length;
  std::size_t a, b;  ///< a < b
};

/// The longest edge on top; among equals the one with the lowest indices.
struct Later {
  bool operator()(const Pair& one, const Pair& other) const {
    return std::tie(one.length, other.a, other.b) < std::tie(other.length, one.a, one.b);
  }
};

/// Pairs that were eligible when added. Every pair eligible now is among them, with its present length.
class Queue {
 public:
  Queue(const MergeGraph& graph, const MergeRule& rule) : graph_(graph), rule_(rule) {
    for (std::size_t a = 0; a < graph.nodes.size(); ++a)
      for (const auto& [b, length] : graph.nodes[a].shared)
        if (a < b) add(a, b, length);
  }

  bool empty() const { return pairs_.empty(); }

  Pair take() {
    const Pair pair = pairs_.top();
    pairs_.pop();
    return pair;
  }

  /// Whether the pair is unchanged since it was added.
  bool is_current(const Pair& pair) const {
    const auto& shared = graph_.nodes[pair.a].shared;
    const auto found = shared.find(pair.b);
    return found != shared.end() && found->second == pair.length && eligible(pair);
  }

  /// Updates the pairs after a merge into `node`, whose direction may have changed; `beside` were neighbours
  /// of the node merged away.
  void update(std::size_t node, bool turned, const std::vector<std::size_t>& beside) {
    using Opens = MergeRule::Opens;
    if (rule_.opens == Opens::kWithAnyChange || (rule_.opens == Opens::kWithDirection && turned))
      add_pairs_of(node);
    else
      for (const std::size_t other : beside) add(node, other, graph_.nodes[node].shared.at(other));
    if (rule_.opens == Opens::kWithAnyChange)
      for (const std::size_t other : beside) add_pairs_of(other);
  }

 private:
  bool eligible(const Pair& pair) const { return rule_.eligible(graph_.nodes[pair.a], graph_.nodes[pair.b]); }

  void add(std::size_t one, std::size_t other, double length) {
    const Pair pair{length, std::min(one, other), std::max(one, other)};
    if (length > 0 && eligible(pair)) pairs_.push(pair);
  }

  void add_pairs_of(std::size_t node) {
    for (const auto& [other, length] : graph_.nodes[node].shared) add(node, other, length);
  }

  const MergeGraph& graph_;
  const MergeRule& rule_;
  std::priority_queue<Pair, std::vector<Pair>, Later> pairs_;
};

std::vector<std::size_t> neighbours_of(const MergeNode& node, std::size_t except) {
  std::vector<std::size_t> out;
  for (const auto& [neighbour, length] : node.shared)
    if (neighbour != except) out.push_back(neighbour);
  return out;
}

}  // namespace

void merge_longest_edge_first(MergeGraph& graph, Remember remember, const MergeRule& rule) {
  Queue queue(graph, rule);
  while (!queue.empty()) {
    const Pair pair = queue.take();
    if (!queue.is_current(pair)) continue;
    const Direction before = graph.nodes[pair.a].direction;
    const std::vector<std::size_t> beside = neighbours_of(graph.nodes[pair.b], pair.a);
    merge(graph, pair.a, pair.b, remember);
    queue.update(pair.a, !(graph.nodes[pair.a].direction == before), beside);
  }
}

}  // namespace tramline
