#pragma once
// Merging, phase 1.

#include "tramline/decomposition/merge_graph.h"

namespace tramline {

/// S1.20: adjacent cells with the same driving direction become one.
void merge_equal_directions(MergeGraph& graph);

}  // namespace tramline
