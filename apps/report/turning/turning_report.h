#pragma once
// The planned turns of a plan, in words and as JSON.

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "tramline/model/plan.h"

namespace tramline::app {

/// The key `planned_turns` (docs/json.md). All 0 where none were planned.
nlohmann::ordered_json planned_turns_json(const Plan& plan);

/// Rows of the summary; "" where no turns were planned.
std::string turning_rows(const Plan& plan);

}  // namespace tramline::app
