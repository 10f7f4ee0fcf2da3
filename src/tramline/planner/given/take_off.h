#pragma once
// Takes off the land to plan what the user says is done, lies elsewhere or is to be left out.

#include "tramline/avoidance/obstacles/obstacle_classification.h"
#include "tramline/planner/given/prepared_land.h"
#include "tramline/planner/planning_problem.h"

namespace tramline {

/// Takes land done and land elsewhere off the body, with what remains beside land done in parts too small or
/// too narrow to plan (is_sliver_part()); swaths may run on over it. Land left out is given up instead: it
/// stays in the body, and no swath enters it. Throws kBadInput where no land to plan remains.
void take_off_given(const PlanningProblem& problem, ClassifiedGround& ground, PreparedLand& out);

}  // namespace tramline
