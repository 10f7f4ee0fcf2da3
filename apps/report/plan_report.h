#pragma once
// What `plan` says about a plan.

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "tramline/model/plan.h"

namespace tramline::app {

/// The keys of docs/json.md.
nlohmann::ordered_json plan_json(const Plan& plan, const std::vector<Skipped>& skipped, double seconds);

/// A table for people of what plan_summary() leaves out: how the plan was searched for, its cost and the
/// bound, repairs, what was left aside, and notes. Every number with its unit.
std::string plan_details(const Plan& plan, const std::vector<Skipped>& skipped, double seconds);

}  // namespace tramline::app
