#pragma once
// Where the lines of a repair may lie.

#include <vector>

#include "tramline/planner/repair/repair_ground.h"

namespace tramline {

/// Places worth looking at, by direction and then from left to right, each once: strips flush with the edges
/// of the gaps or about their middles, side by side over wide ones, flush with straight boundaries along
/// them, and every eighth of a width in between. O(gaps · widths across them, and edges of the field).
std::vector<LinePlace> repair_places(const RepairGround& ground);

/// Those of them that meet one gap.
std::vector<LinePlace> places_over(std::size_t gap, const RepairGround& ground);

}  // namespace tramline
