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

/// A way with the work on: a piece, whose number is its place in the plan, or a headland pass, whose number
/// is that of all pieces and its own place.
struct PlanRun {
  int run = 0;
  Path path;
};

/// All runs of the plan. Where it has a route, in the order of the route, each in the sense in which that
/// drives it, and closed passes from where it enters them; pieces and passes that no leg works come last.
/// Else pieces, then headland passes. A pass that the route interrupts is one run. O(legs, and segments).
std::vector<PlanRun> runs_of(const Plan& plan);

/// All steps of the plan: those of its runs, in their order and under their numbers. On passable obstacles
/// the work of headland passes is interrupted. Between the runs the work is off.
std::vector<WorkedStep> steps_of(const Plan& plan);

}  // namespace tramline::coverage
