#pragma once
// The report of `price`: the figures of given lines, and of the plan that they are compared with.

#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "tramline/model/plan.h"

namespace tramline::app {

struct PricedPlans {
  const Plan& given;
  const Plan* planned = nullptr;  ///< nullptr: not asked for
  const std::vector<Skipped>& skipped;
  double seconds = 0;
};

/// The keys of plan_json() for the lines; with a plan to compare with `given`, `planned` and `difference`
/// (docs/json.md).
nlohmann::ordered_json price_json(const PricedPlans& plans);

/// A table for people: the rows of plan_summary(), the cost, all notes and what was skipped, and, with a plan
/// to compare with, both side by side with the differences, planned less given, and their share of the given
/// figure.
std::string price_table(const PricedPlans& plans);

}  // namespace tramline::app
