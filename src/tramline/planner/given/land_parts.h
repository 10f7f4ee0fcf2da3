#pragma once
// The parts of the land between the borders that the user drew.

#include "tramline/planner/given/prepared_land.h"
#include "tramline/planner/planning_problem.h"

namespace tramline {

/// Divides the plannable land: each given subfield takes its share, lines cut the rest, and what no line cuts
/// stays free. A line is extended by a working width at either end, so that it need not quite reach the edge.
/// Parts too small or too narrow (is_sliver_part()) are joined to the neighbour with which they share the
/// longest border. Sets `out.parts`, which together are the land, and adds a remark for each part joined and
/// for each shape without effect. O(parts²) polygon unions.
void divide_as_given(const PlanningProblem& problem, const Region& plannable, PreparedLand& out);

}  // namespace tramline
