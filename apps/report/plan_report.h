#pragma once
// What `plan` says about a plan.

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "tramline/model/plan.h"

namespace tramline::app {

/// The keys of docs/json.md.
nlohmann::ordered_json plan_json(const Plan& plan, const std::vector<Skipped>& skipped, double seconds);

/// A table for people: every number with its unit.
std::string plan_table(const Plan& plan, const std::vector<Skipped>& skipped, double seconds);

/// One line, for runs over many fields.
std::string plan_line(const Plan& plan, double seconds);

}  // namespace tramline::app
