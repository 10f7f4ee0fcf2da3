#pragma once
// A chain of edges as a boundary of its own, so that offset lines run along it alone.

#include "tramline/headland/edges/edge_chain.h"
#include "tramline/headland/turning_room.h"

namespace tramline {

/// The turning room of pass `number` beside the chain and round `obstacles`: the chain is a thin wall, the
/// first of its boundaries, with the pass's distance on both sides. About its ends and behind it the offset
/// line turns at that distance, however tight: no pass is driven there.
TurningRoom room_beside(const EdgeChain& chain, const std::vector<Boundary>& obstacles, double width_m,
                        int number, double radius_m);

/// Consecutive pieces of an offset line.
struct OffsetRun {
  OffsetRing pieces;
  bool closed = false;
};

/// The runs of the room's offset lines beside the chain: without what lies behind its wall and about its
/// ends. The room is that of room_beside() the chain. O(n·m) for n pieces and m edges.
std::vector<OffsetRun> offset_runs(const TurningRoom& room, const EdgeChain& chain);

}  // namespace tramline
