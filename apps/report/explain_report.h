#pragma once
// The report of `plan --explain`: the causes of the cost, and the runner-ups.

#include <nlohmann/json.hpp>
#include <string>

#include "tramline/planner/explain/explanation.h"

namespace tramline::app {

/// The key `explain` of docs/json.md.
nlohmann::ordered_json explain_json(const Explanation& why);

/// Two tables for people: the causes that cost anything, with their share of `cost`, and the runner-ups.
std::string explain_rows(const Explanation& why, double cost);

}  // namespace tramline::app
