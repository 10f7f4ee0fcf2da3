#pragma once
// Phase 2 of merging.

#include "tramline/decomposition/merge_longest_edge_first.h"

namespace tramline {

/// The rule for a cell of less than `small_cell_m2` and the neighbour it shares its longest edge with.
MergeRule small_cells(double small_cell_m2);

/// Versleijen §2.2.3, phase 2: a cell of less than `small_cell_m2` joins the neighbour it shares its longest
/// edge with, whatever the directions. Its direction does not enter the history: it was overruled, not
/// merged.
void merge_small_cells(MergeGraph& graph, double small_cell_m2);

}  // namespace tramline
