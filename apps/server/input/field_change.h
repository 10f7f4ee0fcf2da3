#pragma once
// What is drawn into a field, and taken out of it.

#include <nlohmann/json_fwd.hpp>

#include "tramline/model/field.h"

namespace tramline::server {

/// Takes obstacles away by their numbers (from 1, as the shapes of a field have them) and adds those that
/// were drawn: points and lines get their size, everything is cut to the field. `remove`: a list of numbers;
/// `add`: a list of {kind, geometry, size_m?}. Throws bad_input for a number that there is not, and for a
/// shape that does not meet the field.
Field changed_field(Field field, const nlohmann::ordered_json& remove, const nlohmann::ordered_json& add);

}  // namespace tramline::server
