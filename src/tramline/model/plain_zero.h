#pragma once

namespace tramline {

/// The value, with negative zero replaced by 0, because files and reports would write it as "-0".
constexpr double plain_zero(double value) { return value + 0.0; }

}  // namespace tramline
