#pragma once
// Evaluations as every face makes them: of the drive of a plan, and of a log.

#include <optional>
#include <string>
#include <vector>

#include "report/evaluate_report.h"
#include "request/evaluate_input.h"
#include "tramline/coverage/evaluate.h"
#include "tramline/model/plan.h"
#include "tramline/model/work_log.h"

namespace tramline::app {

/// The drive of a plan, headland passes too, over the ground it has to cover: the field less its obstacles,
/// or what a repair is for. The figures of plans of earlier versions are of the tracks and the body alone.
/// `name`: of the plan, for people. O(n log n) in vertices.
Evaluation evaluation_of_plan(const Plan& plan, const std::string& name,
                              const coverage::EvaluateSettings& settings);

struct NamedPlan {
  const Plan& plan;
  std::string name;  ///< for people
};

/// The plans that an evaluated drive has to do with.
struct PlansOfDrive {
  std::optional<NamedPlan> compared{};  ///< the drive is compared with what it works
  const std::vector<Plan>& with;        ///< their drives count as done after that of the log, one by one
};

/// The drive of a log. Without a field in `ground` that of the first plan of `with` is the ground, where
/// there is one. Throws kBadInput where the log lies nowhere near its ground, or as coverage::evaluate()
/// does.
Evaluation evaluation_of_drive(WorkLog log, WorkGround ground, const PlansOfDrive& plans,
                               const coverage::EvaluateSettings& settings,
                               const coverage::FixProgress& progress);

}  // namespace tramline::app
