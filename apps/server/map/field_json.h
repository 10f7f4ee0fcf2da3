#pragma once

#include <nlohmann/json.hpp>

#include "server/store/field_store.h"

namespace tramline::server {

/// An entry of the list of fields.
nlohmann::ordered_json field_entry(const KeptField& kept);
/// A field with its shapes.
nlohmann::ordered_json field_in_full(const KeptField& kept);

/// Its outline with few corners, for a map of all fields, as a GeoJSON polygon.
nlohmann::ordered_json field_outline(const KeptField& kept);

}  // namespace tramline::server
