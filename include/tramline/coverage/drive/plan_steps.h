#pragma once
// The drive that a plan plans (S3.17).

#include <vector>

#include "tramline/coverage/drive/worked_step.h"
#include "tramline/model/plan.h"

namespace tramline::coverage {

/// Arcs are driven in chords that the outer edge of the swath leaves by at most this, m.
inline constexpr double kPlanSagitta_m = 2e-5;

/// What the pieces of a plan work, in driving order, each a run of its own. Ends of steps are square to the
/// path. O(pieces, and chords of arcs).
std::vector<WorkedStep> plan_steps(const Plan& plan);

/// What its headland passes work, each a run of its own; numbered from `first_run`. On passable obstacles the
/// work is interrupted. O(passes, chords of arcs, and edges of passable obstacles beside them).
std::vector<WorkedStep> headland_steps(const Plan& plan, int first_run);

/// All that the plan works: pieces, then headland passes.
std::vector<WorkedStep> steps_of(const Plan& plan);

}  // namespace tramline::coverage
