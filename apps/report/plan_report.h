#pragma once
// The report of `plan`.

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "tramline/model/plan.h"

namespace tramline::app {

/// The keys of docs/json.md.
nlohmann::ordered_json plan_json(const Plan& plan, const std::vector<Skipped>& skipped, double seconds);

/// A table for people with the details that plan_summary() omits: the search, its cost and the bound,
/// repairs, skipped features, and notes. Every number with its unit.
std::string plan_details(const Plan& plan, const std::vector<Skipped>& skipped, double seconds);

}  // namespace tramline::app
