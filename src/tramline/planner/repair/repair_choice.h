#pragma once
// Which lines a repair drives.

#include <vector>

#include "tramline/planner/repair/repair_ground.h"
#include "tramline/planner/search_context.h"

namespace tramline {

/// What lines cost with what they leave: the open ground at the price of missed land, their overlap (as
/// price_of() has it for short ones), stops, and a turn to each line, the first too: the way to it costs
/// no less. The ground has to be covered by just these. O(open ground).
double cost_with(const std::vector<RepairLine>& lines, const RepairGround& ground);

/// Lines that together cost little, see cost_with(): none may be left out, or exchanged for others of
/// repair_places(), and none of those may be added, so that it costs less; nor may two that are neighbours be
/// exchanged for others. Begun once with the line that is worth most, time and again, and twice with the best
/// rows of lines over wide gaps; the best outcome counts. Covers the ground. Deterministic for any number of
/// threads. O(lines · places beside them) looks at the ground.
std::vector<RepairLine> chosen_lines(RepairGround& ground, const SearchContext& context);

}  // namespace tramline
