#pragma once
// Changes to the obstacles of a field.

#include <nlohmann/json_fwd.hpp>

#include "tramline/model/field.h"

namespace tramline::server {

/// Removes obstacles by their numbers (from 1, as in the shapes of a field) and adds drawn ones: points and
/// lines get their size, everything is cut to the field. `remove`: a list of numbers; `add`: a list of {kind,
/// geometry, size_m?}. Throws bad_input for a number that does not exist, and for a shape outside the field.
Field changed_field(Field field, const nlohmann::ordered_json& remove, const nlohmann::ordered_json& add);

}  // namespace tramline::server
