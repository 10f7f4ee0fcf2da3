#pragma once
// Chooses the lines that a repair drives.

#include <vector>

#include "tramline/planner/repair/repair_ground.h"
#include "tramline/planner/search_context.h"

namespace tramline {

/// The cost of lines and of the land they leave: the open area at the price of missed land, the lines'
/// overlap (counted for short ones as in price_of()), stops, and a turn to each line, including the first,
/// since the way to it costs no less. `ground` has to be covered by exactly these lines. O(open area).
double cost_with(const std::vector<RepairLine>& lines, const RepairGround& ground);

/// A set of lines with low cost_with(): leaving out a line, exchanging one line or two neighbours for others
/// of line_positions(), or adding one of these does not lower the cost. The search starts three times: once
/// by adding the line of most worth again and again, and twice with the best rows of lines over wide gaps;
/// the best outcome counts. `ground` is left covered by the result. Deterministic for any number of threads.
/// O(lines · positions beside them) evaluations of the ground.
std::vector<RepairLine> chosen_lines(RepairGround& ground, const SearchContext& context);

}  // namespace tramline
