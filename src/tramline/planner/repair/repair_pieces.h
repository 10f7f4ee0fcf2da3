#pragma once
// Converts the lines of a repair to subfields and pieces of a plan.

#include <vector>

#include "tramline/model/plan.h"
#include "tramline/planner/repair/repair_ground.h"

namespace tramline {

/// Adds a subfield for each polygon of the gaps, with the direction in which most of it is worked, and the
/// pieces in driving order. The part of a gap that only lines of another direction work becomes a subfield of
/// its own. `worked`: indices of the gaps that the lines work, which are the plan's body. O(gaps · lines near
/// them).
void add_lines(Plan& plan, const std::vector<std::size_t>& worked, const std::vector<RepairLine>& lines,
               const RepairGround& ground);

}  // namespace tramline
