#pragma once
// S1's obstacle category c: an obstacle closer to the field's edge than the working width is joined
// to the edge.

#include "tramline/avoidance/obstacles/clusters.h"

namespace tramline {

/// Gives up the land between the edge and every cluster nearer to it than `width_m` (S1.28). The rim
/// of a clipped obstacle stays hard.
void clip_to_edge(std::vector<Cluster>& clusters, const Ring& outer, double width_m);

}  // namespace tramline
