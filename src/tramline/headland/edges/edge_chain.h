#pragma once
// Runs of edges of the field that have a headland.

#include <vector>

#include "tramline/geometry/polygon/region.h"

namespace tramline {

/// Consecutive edges of a ring, walked along it: the land is on the left. At least one edge, and not all.
using EdgeChain = std::vector<Point>;

/// The longest runs of edges with at least `number` passes, by their first edges; none where all edges have
/// that many. Edges without length are left out. Precondition: a number for each edge of the ring.
std::vector<EdgeChain> chains_with(const Ring& ring, const std::vector<int>& edge_passes, int number);

/// One end of a chain: where it ends, away from the chain, and into the land.
struct ChainEnd {
  Point at;
  Point ahead;  ///< unit vectors
  Point inland;
};
ChainEnd first_end(const EdgeChain& chain);
ChainEnd last_end(const EdgeChain& chain);

}  // namespace tramline
