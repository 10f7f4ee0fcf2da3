#pragma once
// How long the shortest ways from one pose to another are, for a machine of least radius: lower bounds of
// every way that it can drive.

#include "tramline/geometry/path/steered_path.h"

namespace tramline::check {

/// Forward: the shortest of the six words of Dubins (1957), m. Turns that would be shorter than 1e-8 of a
/// full circle count as none, so that rounding cannot make full circles of them. O(1). Precondition:
/// radius_m > 0.
double least_forward_m(const Pose& from, const Pose& to, double radius_m);

/// Forward or in reverse, with any changes of gear: the shortest word of Reeds and Shepp (1990), m. From the
/// centres of the circles, as products of complex numbers: every part may go either way, so each of the
/// paper's families is one equation. O(1). Precondition: radius_m > 0.
double least_with_reversing_m(const Pose& from, const Pose& to, double radius_m);

}  // namespace tramline::check
