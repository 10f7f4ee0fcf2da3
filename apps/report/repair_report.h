#pragma once
// The report of `repair`, as a table and as JSON.

#include <nlohmann/json.hpp>
#include <string>

#include "tramline/planner/repair/repair_plan.h"

namespace tramline::app {

/// Keys: docs/json.md.
nlohmann::ordered_json repair_json(const RepairPlan& repair, double min_area_m2, double seconds);
std::string repair_table(const RepairPlan& repair, double min_area_m2, double seconds);

}  // namespace tramline::app
