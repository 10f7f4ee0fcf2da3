#pragma once
// Tours to begin with: three ways of going over all lines.

#include <vector>

#include "tramline/planner/order/blocks.h"
#include "tramline/planner/order/hop_costs.h"

namespace tramline::order {

/// Always the nearest end not driven yet, along straight lines; entering the first line by the
/// given end. n steps, each as PlaceGrid::nearest().
Tour nearest_neighbour(const HopCosts& costs, End first);

/// Subfield by subfield, from the first line of the first one and then from the nearest corner of one not yet
/// worked; within it track after track, each the other way, whatever lies on them. Precondition: lines come
/// by subfield, track and place along it.
Tour track_by_track(const std::vector<WorkedLine>& lines, const HopCosts& costs);

/// Block by block, each up and down. Blocks in an order that is shortened as lines are, each in the best of
/// its four ways for that order.
Tour block_by_block(const std::vector<Block>& blocks, HopCosts& costs);

}  // namespace tramline::order
