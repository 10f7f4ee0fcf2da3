#pragma once
// What counts as no ground in sums of areas.

#include "tramline/geometry/tolerances.h"
#include "tramline/tracks/tolerances.h"

namespace tramline {

/// A swath whose exact area leaves no more of its subfield leaves nothing of it, m²: rounding.
inline constexpr double kNoOverlap_m2 = 1e-9;
/// Differences of areas that ought to be equal are none below this, m²: each of them is a sum over a field.
inline constexpr double kNoDifference_m2 = 1e-6;
/// Intersections of two swaths that are thinner are no overlap, m: corners of swaths are rounded to the
/// precision grid.
inline constexpr double kThinnestOverlap_m = 1e-5;

// A sum is off by more than what it is made of.
static_assert(kNoOverlap_m2 < kNoDifference_m2);
// What the grid or the tolerance of widths leaves of two swaths that lie beside one another is no overlap.
static_assert(kThinnestOverlap_m >= 10 * kGridSize && kThinnestOverlap_m >= kWidthTolerance);

}  // namespace tramline
