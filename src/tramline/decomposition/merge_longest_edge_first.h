#pragma once
// The order in which cells are merged.

#include <cstdint>
#include <functional>

#include "tramline/decomposition/merge_graph.h"

namespace tramline {

/// The rule for which neighbours may merge.
struct MergeRule {
  /// Depends only on the two nodes.
  std::function<bool(const MergeNode&, const MergeNode&)> eligible;
  /// The changes that can make two ineligible neighbours eligible.
  enum class Opens : std::uint8_t { kNever, kWithDirection, kWithAnyChange } opens = Opens::kWithAnyChange;
};

/// Merges, again and again, the eligible pair of neighbours with the longest shared edge (ties: the lower
/// indices) until no pair is eligible. Versleijen §2.2.3 leaves the order open. O((E + M·d) log E) for E
/// pairs of neighbours, M merges and the d neighbours of the merged-away node; where any change makes pairs
/// eligible, d also counts the neighbours of the remaining node and of these neighbours.
void merge_longest_edge_first(MergeGraph& graph, Remember remember, const MergeRule& rule);

}  // namespace tramline
