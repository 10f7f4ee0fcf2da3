#pragma once
// Tolerances of areas.

#include "tramline/geometry/tolerances.h"
#include "tramline/tracks/tolerances.h"

namespace tramline {

/// A swath whose exact area leaves no more of its subfield uncovered leaves nothing, m²: rounding.
inline constexpr double kNoOverlap_m2 = 1e-9;
/// Smaller differences of areas that ought to be equal count as 0, m²: each of these is a sum over a field.
inline constexpr double kNoDifference_m2 = 1e-6;
/// Thinner intersections of two swaths are no overlap, m: corners of swaths are rounded to the precision
/// grid.
inline constexpr double kThinnestOverlap_m = 1e-5;

// A sum is less exact than its terms.
static_assert(kNoOverlap_m2 < kNoDifference_m2);
// Slivers that the grid or the tolerance of widths leaves between adjacent swaths are no overlap.
static_assert(kThinnestOverlap_m >= 10 * kGridSize && kThinnestOverlap_m >= kWidthTolerance);

}  // namespace tramline
