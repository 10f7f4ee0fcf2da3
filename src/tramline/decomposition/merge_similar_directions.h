#pragma once
// Phase 3 of merging.

#include "tramline/decomposition/merge_longest_edge_first.h"

namespace tramline {

/// The rule for neighbours with histories whose directions differ by at most `threshold`.
MergeRule similar_directions(Angle threshold);

/// Versleijen §2.2.3, phase 3: adjacent subfields whose directions differ by at most `threshold` merge.
/// History rule (fig. 16): every direction merged into one must lie within the threshold of every direction
/// merged into the other, so that a chain of small differences never joins subfields with very different
/// directions.
void merge_similar_directions(MergeGraph& graph, Angle threshold);

}  // namespace tramline
