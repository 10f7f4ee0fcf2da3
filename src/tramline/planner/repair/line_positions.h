#pragma once
// Candidate positions for the lines of a repair.

#include <vector>

#include "tramline/planner/repair/repair_ground.h"

namespace tramline {

/// Positions worth trying, by direction and then from left to right, each once: strips flush with the edges
/// of the gaps or centred on them, side by side over wide ones, flush with straight boundaries along them,
/// and at every eighth of a width in between. O(gaps · widths across them, and edges of the field).
std::vector<LinePosition> line_positions(const RepairGround& ground);

/// The positions among them whose strips reach one gap.
std::vector<LinePosition> line_positions_over(std::size_t gap, const RepairGround& ground);

}  // namespace tramline
