#pragma once
// Comparison of the work done with the plan.

#include <string>

#include "tramline/coverage/deviation.h"
#include "tramline/coverage/evaluate.h"
#include "tramline/model/plan.h"
#include "tramline/model/work_log.h"

namespace tramline::app {

/// The areas of a drive compared with those of a plan.
struct PlanAndDone {
  std::string plan;
  coverage::Deviation deviation;
  double planned_m2 = 0;               ///< area that tracks and headland passes work
  double planned_missed_m2 = 0;        ///< the part of it not worked
  double planned_not_recorded_m2 = 0;  ///< the part of it perhaps worked while the log has no fixes
  double unplanned_m2 = 0;             ///< worked, and not planned
};

/// Compares the drive with the land that the plan works: how much of that is missed, and how much work lies
/// outside it. `read`: the log as read. `plan_name`: for people. Throws kBadInput where the log lies nowhere
/// near the plan's field, or as evaluate() does. O(fixes) and the regions.
PlanAndDone plan_and_done(const Plan& plan, std::string plan_name, WorkLog read,
                          const coverage::EvaluateSettings& settings, const coverage::FixProgress& progress);

}  // namespace tramline::app
