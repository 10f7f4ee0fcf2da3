#pragma once
// From a field, a machine and an objective to a plan.

#include <optional>

#include "tramline/model/explanation.h"
#include "tramline/model/plan.h"
#include "tramline/planner/progress.h"

namespace tramline {

/// Plans a field by the strategy of the settings. `threads` 0 uses all cores.
/// Errors: kBadInput where the machine or the objective is not a number or out of range, or where no
/// piece of the least length fits (the machine is too wide, or the field too small).
/// Deterministic: the same plan for any number of threads, unless the progress wants an end before the search
/// is through; the plan then says so (Proof::cut_short, and a warning).
Plan plan_field(const Field& field, const Machine& machine, const Objective& objective,
                const PlanSettings& settings, int threads = 0, const Progress& progress = {});

struct ExplainedPlan {
  Plan plan;
  std::optional<Explanation> why;  ///< of straight tracks only: curved ones have no causes to tell
};

/// The same plan, and why it is the one where it has straight tracks. Takes longer: runner-ups have to be
/// laid out.
ExplainedPlan plan_and_explain(const Field& field, const Machine& machine, const Objective& objective,
                               const PlanSettings& settings, int threads = 0, const Progress& progress = {});

}  // namespace tramline
