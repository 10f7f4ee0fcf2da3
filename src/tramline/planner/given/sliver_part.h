#pragma once
// Parts that are too small to be worth a subfield.

#include "tramline/planner/planning_problem.h"

namespace tramline {

/// Whether a part is smaller than PlanSettings::small_cell_m2, or nowhere as wide as the machine.
bool is_sliver_part(const PlanningProblem& problem, const Polygon& part);

/// Leaves out polygons that are only effects of rounding, smaller than kNoGround_m2.
void drop_specks(Region& region);

}  // namespace tramline
