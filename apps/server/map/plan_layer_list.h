#pragma once

#include <nlohmann/json.hpp>

#include "tramline/model/plan.h"

namespace tramline::server {

/// The layers of a plan's file that have shapes, in the order to draw them: [{name, title, features, m2, m}].
nlohmann::ordered_json layer_list(const Plan& plan);

}  // namespace tramline::server
