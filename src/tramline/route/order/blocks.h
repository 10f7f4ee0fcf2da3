#pragma once
// Lines that lie side by side.

#include <cstddef>
#include <vector>

#include "tramline/route/order/lines.h"

namespace tramline::order {

/// Indices of lines on neighbouring tracks of a subfield, by track, each facing the one before and the one
/// after it and no other: they can simply be driven up and down (a cell of a boustrophedon decomposition).
using Block = std::vector<std::size_t>;

/// Every line in one block. Two lines face one another where one begins or ends beside the other, no farther
/// off than neighbouring tracks. Blocks are in the order of their first lines. O(n log n) where few lines
/// share a track; for curved ones times their segments.
std::vector<Block> blocks_of(const std::vector<WorkedLine>& lines, double width_m);

}  // namespace tramline::order
