#pragma once
// How large things may be.

namespace tramline {

/// Nothing in a field's local frame lies farther than this from its origin, and no length of a machine
/// or a plan is larger, m. Beyond it arithmetic overflows sooner or later.
inline constexpr double kFarthest_m = 1e7;

}  // namespace tramline
