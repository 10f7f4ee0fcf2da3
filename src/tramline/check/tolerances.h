#pragma once
// How far a plan may be from the exact definitions.

namespace tramline::check {

/// Along and across a piece, m: what no machine can tell.
inline constexpr double kLengthTolerance_m = 1e-3;
/// Area of the smallest overlap that counts as one, m²: five micrometres over a millimetre, above what the
/// precision grid can move an edge.
inline constexpr double kTouch_m2 = 5e-9;
/// Of the field's area, for sums of areas.
inline constexpr double kAreaShare = 1e-6;

/// Nothing in a field's local frame lies farther than this from its origin, nor is wider, m. Beyond it
/// arithmetic overflows sooner or later.
inline constexpr double kFarthest_m = 1e7;

}  // namespace tramline::check
