#pragma once

#include <nlohmann/json.hpp>

#include "tramline/model/plan.h"

namespace tramline::server {

/// How deep the headland is along the sides of the field, each from corner to corner or to where the number
/// of passes changes: [{length_m, bearing_deg, passes, depth_m}], the longest first. Empty where there are no
/// passes along the boundary. O(n log n).
nlohmann::ordered_json headland_sides(const Plan& plan);

}  // namespace tramline::server
