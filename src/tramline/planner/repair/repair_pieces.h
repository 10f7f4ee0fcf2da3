#pragma once
// The lines of a repair as subfields and pieces of a plan.

#include <vector>

#include "tramline/model/plan.h"
#include "tramline/planner/repair/repair_ground.h"

namespace tramline {

/// Adds a subfield for each polygon of the gaps, with the direction in which most of it is worked – what only
/// lines of another direction work is a subfield of theirs – and the pieces in driving order. `worked`: the
/// gaps that the lines work, and the plan's body. O(gaps · lines near them).
void add_lines(Plan& plan, const std::vector<std::size_t>& worked, const std::vector<RepairLine>& lines,
               const RepairGround& ground);

}  // namespace tramline
