#pragma once

#include <nlohmann/json.hpp>

#include "tramline/io/plan/read_plan.h"

namespace tramline::server {

/// The layers of a plan file that have shapes, in the order to draw them: [{name, title, features, m2, m}].
nlohmann::ordered_json layer_list(const io::PlanFile& file);

}  // namespace tramline::server
