#pragma once
// Phase 1 of merging.

#include "tramline/decomposition/merge_longest_edge_first.h"

namespace tramline {

/// The rule for neighbours with the same driving direction.
MergeRule equal_directions();

/// Versleijen §2.2.3, phase 1: adjacent cells with the same driving direction become one.
void merge_equal_directions(MergeGraph& graph);

}  // namespace tramline
