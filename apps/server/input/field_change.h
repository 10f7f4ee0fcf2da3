#pragma once
// Changes to the boundary and the obstacles of a field.

#include <nlohmann/json_fwd.hpp>

#include "tramline/model/field.h"

namespace tramline::server {

/// Removes obstacles by their numbers (from 1, as in the shapes of a field) and adds drawn ones: points and
/// lines get their size, everything is cut to the field. `remove`: a list of numbers; `add`: a list of {kind,
/// geometry, size_m?}. Throws bad_input for a number that does not exist, and for a shape outside the field.
Field changed_field(Field field, const nlohmann::ordered_json& remove, const nlohmann::ordered_json& add);

/// The field within another boundary, a GeoJSON polygon on the map: obstacles stay where they are, and what
/// of them lies beyond is cut off. Throws bad_input for a boundary that makes no field, or more than one.
Field with_boundary(const Field& field, const nlohmann::ordered_json& boundary);

}  // namespace tramline::server
