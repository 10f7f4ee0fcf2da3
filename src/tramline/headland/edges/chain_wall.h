#pragma once
// A chain of edges as a boundary of its own, so that offset lines run along it alone.

#include "tramline/headland/edges/edge_chain.h"
#include "tramline/headland/turning_room.h"

namespace tramline {

/// The turning room of a pass beside a chain.
struct RoomBeside {
  TurningRoom room;     ///< the chain's wall is the first of its boundaries
  double end_m = 0;     ///< so near to the chain's ends the offset line may leave its distance
};

/// The turning room of pass `number` beside the chain and round `obstacles`: the chain is a thin wall,
/// on its own side of the boundary, with the pass's distance on both sides. About its two ends the offset line
/// turns at that distance, however tight: no pass is driven there.
RoomBeside room_beside(const EdgeChain& chain, const std::vector<Boundary>& obstacles, double width_m,
                       int number, double radius_m);

}  // namespace tramline
