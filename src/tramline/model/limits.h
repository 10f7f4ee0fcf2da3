#pragma once
// Limits on sizes.

namespace tramline {

/// The largest distance from the origin in a field's local frame, and the largest length of a machine or a
/// plan, m. Beyond it arithmetic overflows sooner or later.
inline constexpr double kFarthest_m = 1e7;

}  // namespace tramline
