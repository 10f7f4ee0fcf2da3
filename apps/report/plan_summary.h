#pragma once
// The summary of a plan: six lines for the driver, or one line in a run over many fields.

#include <string>
#include <vector>

#include "tramline/model/plan.h"

namespace tramline::app {

/// Whether a search has proven what no plan undercuts.
bool is_proven(const Plan& plan);

/// Hectares to work, passes, distance at work, land worked twice, land missed, and peculiarities of the plan.
/// Six lines, each with its unit, one more where a bound of the cost is proven, and one where a front was
/// asked for. O(n) in pieces and vertices.
std::string plan_summary(const Plan& plan, const std::vector<Skipped>& skipped);

/// The rows of plan_summary() before its note.
std::string figure_rows(const Plan& plan);

/// The same in one line that begins with the field's id, with the time it took.
std::string plan_line(const Plan& plan, double seconds);

}  // namespace tramline::app
