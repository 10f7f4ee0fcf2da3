#pragma once
// The order in which cells are merged.

#include <cstdint>
#include <functional>

#include "tramline/decomposition/merge_graph.h"

namespace tramline {

/// Which neighbours may merge.
struct MergeRule {
  /// Depends on nothing but the two nodes.
  std::function<bool(const MergeNode&, const MergeNode&)> eligible;
  /// What can make two neighbours eligible that were not.
  enum class Opens : std::uint8_t { kNever, kWithDirection, kWithAnyChange } opens = Opens::kWithAnyChange;
};

/// Merges, again and again, the eligible pair of neighbours with the longest shared edge (ties: the
/// lower indices) until no pair is eligible. S1 leaves the order open (S1.25).
/// O((E + M·d) log E) for E pairs of neighbours, M merges and the d neighbours of what is gone; where any
/// change makes pairs eligible, also of what is left and of those neighbours.
void merge_longest_edge_first(MergeGraph& graph, Remember remember, const MergeRule& rule);

}  // namespace tramline
