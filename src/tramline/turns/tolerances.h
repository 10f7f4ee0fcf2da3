#pragma once
// Tolerances of manoeuvres: what counts as no turn, as none of a line, and as equal.

namespace tramline {

/// A turn whose angle is this near to 0 or to a whole circle is none, rad, where it is followed by a way of a
/// radius: poses in line would otherwise ask for a loop by rounding alone. For other distances d the angle is
/// the same over d/r, so that the end is displaced by no more than this share of the radius.
inline constexpr double kNoTurnAtRadius_rad = 1e-11;
/// Bounds of that angle for long and short ways, rad: what headings and their sines are exact to, and what
/// no pose is meant to differ by.
inline constexpr double kNoTurnLeast_rad = 1e-13;
inline constexpr double kNoTurnMost_rad = 1e-6;
/// Shorter lines are left out, as a share of the radius.
inline constexpr double kNoLine = 1e-11;
/// Circles that miss touching each other by this share of the square of their distance touch.
inline constexpr double kTouches = 1e-13;
/// Arcs that differ by no more are equal, and tracks antiparallel, rad: what rounded coordinates do to them.
/// Decides only how a manoeuvre is called.
inline constexpr double kEqualArcs_rad = 1e-6;
/// Manoeuvres of one word whose stretches differ by no more are one, m.
inline constexpr double kSameStretch_m = 1e-7;
/// Lengths and times are compared in whole multiples of this, m or s: what is equal but for rounding keeps
/// its order.
inline constexpr double kEqualAmount = 1e-7;
/// A turn may be sharper than the wheels can be turned by this share: a turn of exactly two full clothoids.
inline constexpr double kSharper = 1e-9;
/// A headland that lacks so little of a depth is deep enough: in passes where these are counted, in metres
/// where depths are compared.
inline constexpr double kSameDepth = 1e-9;

}  // namespace tramline
