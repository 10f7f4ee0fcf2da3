#pragma once
// Whether two shapes of a field are the same.

#include <string>

#include "tramline/model/field.h"

namespace tramline::server {

/// A text that differs where the boundary or an obstacle does by a millimetre or more, and is the same where
/// corners differ by rounding only. 64 bits, in hexadecimal. O(vertices).
std::string shape_key(const Field& field);

}  // namespace tramline::server
