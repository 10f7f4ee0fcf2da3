#pragma once
// The land that passes along some edges of the field are meant to work.

#include "tramline/headland/edges/edge_chain.h"

namespace tramline {

/// How passes end at one end of a chain.
enum class ChainEnding {
  kAtBoundary,  ///< they go straight on to the boundary, which is near there
  kFlat,        ///< at right angles to the chain's last edge: straight on there is more field
};

/// Land along a chain.
struct ChainGround {
  Region land;  ///< obstacles are still in it
  ChainEnding first = ChainEnding::kAtBoundary;
  ChainEnding last = ChainEnding::kAtBoundary;
};

/// All land left of the chain that is nearer to it than `depth_m`, and beyond its ends as far as the boundary
/// where a strip of that depth that goes straight on reaches it within twice the depth; otherwise it ends
/// there at right angles to the chain. Land beyond other boundaries that the strips reach over is not
/// included. Arcs about corners as chords (kBodySagitta). Preconditions: the chain is part of the ring, which
/// is simple; depth_m > 0. O(n log n) for n vertices where few strips overlap.
ChainGround ground_along(const EdgeChain& chain, const Ring& outer, double depth_m);

}  // namespace tramline
