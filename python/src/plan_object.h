#pragma once
// The results that Python holds, as they are inside.

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "report/evaluate_report.h"
#include "tramline/model/plan.h"
#include "tramline/model/report.h"
#include "tramline/planner/pareto/trade_off.h"

namespace tramline::python {

struct PlanObject {
  Plan plan;
  std::vector<Skipped> skipped;
  double seconds = 0;
  std::optional<Plan> planned{};  ///< of lines that were compared with a plan of their field
};

struct EvaluationObject {
  app::Evaluation evaluation;
  std::string json;
};

struct ComparisonObject {
  std::optional<TradeOff> found;  ///< of one machine
  std::string json;
  std::string csv;
};

}  // namespace tramline::python
