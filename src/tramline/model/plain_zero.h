#pragma once

namespace tramline {

/// The value, in its unit, and 0 for the negative zero of arithmetic, which files and reports would
/// write as "-0".
constexpr double plain_zero(double value) { return value + 0.0; }

}  // namespace tramline
