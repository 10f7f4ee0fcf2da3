#pragma once
// The layer of land that a plan works beyond the boundary of its field. It is part of the layer of overlap.

#include <nlohmann/json.hpp>

#include "tramline/model/plan.h"

namespace tramline::server {

inline constexpr const char* kOutsideLayer = "outside";

/// Local metres. O(n log n) for the n vertices of the plan's overlap and of its field.
Region land_outside(const Plan& plan);

/// Its entry in the list of layers.
nlohmann::ordered_json outside_entry(const Plan& plan);

/// GeoJSON, a feature for each polygon with its area. Rings deviate by `detail_m` at most.
nlohmann::ordered_json outside_geojson(const Plan& plan, double detail_m);

}  // namespace tramline::server
