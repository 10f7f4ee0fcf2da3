#pragma once
// The drive of a plan as steps (Zhang §5).

#include <vector>

#include "tramline/coverage/drive/worked_step.h"
#include "tramline/model/plan.h"

namespace tramline::coverage {

/// Arcs become chords; the outer edge of the swath deviates from its arc by at most this, m.
inline constexpr double kPlanSagitta_m = 2e-5;

/// The steps of the pieces of a plan, in driving order, each piece a run of its own. Ends of steps are square
/// to the path. O(pieces, and chords of arcs).
std::vector<WorkedStep> plan_steps(const Plan& plan);

/// The steps of its headland passes, each pass a run of its own, numbered from `first_run`. On passable
/// obstacles the work is interrupted. O(passes, chords of arcs, and edges of passable obstacles beside them).
std::vector<WorkedStep> headland_steps(const Plan& plan, int first_run);

/// All steps of the plan: pieces, then headland passes.
std::vector<WorkedStep> steps_of(const Plan& plan);

}  // namespace tramline::coverage
