#pragma once
// Whether two shapes of a field are the same.

#include <string>

#include "tramline/model/field.h"

namespace tramline::server {

/// A text that differs where the boundary or an obstacle does by a millimetre or more, also where all of the
/// field has moved, and is the same for a shape that is stored and read again. 64 bits, in hexadecimal.
/// O(vertices).
std::string shape_key(const Field& field);

}  // namespace tramline::server
