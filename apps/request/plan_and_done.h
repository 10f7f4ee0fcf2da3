#pragma once
// What was done, against what was planned.

#include <string>

#include "tramline/coverage/deviation.h"
#include "tramline/coverage/evaluate.h"
#include "tramline/model/plan.h"
#include "tramline/model/work_log.h"

namespace tramline::app {

/// What was done compared with a plan.
struct PlanAndDone {
  std::string plan;
  coverage::Deviation deviation;
  double planned_m2 = 0;               ///< ground that tracks and headland passes work
  double planned_missed_m2 = 0;        ///< of that, not worked
  double planned_not_recorded_m2 = 0;  ///< of that, perhaps worked while the log has no fixes
  double unplanned_m2 = 0;             ///< worked, and not planned
};

/// Measured on the ground that the plan works: what is missed of it, and what lies outside it. `read`: as it
/// was read. `plan_name`: for people. Throws kBadInput where the log lies nowhere near the plan's field, or
/// as evaluate() does. O(fixes) and the regions.
PlanAndDone plan_and_done(const Plan& plan, std::string plan_name, WorkLog read,
                          const coverage::EvaluateSettings& settings, const coverage::FixProgress& progress);

}  // namespace tramline::app
