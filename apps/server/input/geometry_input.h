#pragma once
// Shapes that were drawn on the page.

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "tramline/model/raw_feature.h"

namespace tramline::server {

/// A GeoJSON geometry: point, line or polygon, or several of a kind. Coordinates stay longitude and latitude.
/// Throws bad_input that names `place`.
RawFeature raw_feature_in(const nlohmann::ordered_json& geometry, const std::string& place);

}  // namespace tramline::server
