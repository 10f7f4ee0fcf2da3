#pragma once
// What of a plan is driven with the work on, and in which order.

#include <vector>

#include "tramline/coverage/drive/plan_steps.h"
#include "tramline/model/plan.h"

namespace tramline::coverage {

/// Whether the run of this number is along a headland pass, not along a piece.
bool is_of_pass(const Plan& plan, const PlanRun& run);

}  // namespace tramline::coverage
