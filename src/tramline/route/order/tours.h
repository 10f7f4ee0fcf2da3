#pragma once
// Initial tours: three ways of visiting all lines.

#include <vector>

#include "tramline/route/order/blocks.h"
#include "tramline/route/order/hop_costs.h"

namespace tramline::order {

/// Goes to the nearest end not yet driven, along straight lines; enters the first line by the given end. n
/// steps, each as PointGrid::nearest().
Tour nearest_neighbour(const HopCosts& costs, End first);

/// Subfield by subfield, starting with the first line of the first one and then with the nearest corner of a
/// subfield not yet worked; within a subfield track after track in alternating directions, whatever lies on
/// them. Precondition: lines are ordered by subfield, track and position along it.
Tour track_by_track(const std::vector<WorkedLine>& lines, const HopCosts& costs);

/// Block by block, each driven up and down. The order of blocks is shortened like that of lines, and each
/// block is driven in the best of its four ways for that order.
Tour block_by_block(const std::vector<Block>& blocks, HopCosts& costs);

}  // namespace tramline::order
