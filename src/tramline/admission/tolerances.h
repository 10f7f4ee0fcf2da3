#pragma once
// Tolerances of admission: the limits between rounding and faults. Vertices closer than kSamePlace_m are one
// vertex, and a spike thinner than that has no width.

#include <algorithm>

#include "tramline/geometry/tolerances.h"

namespace tramline {

/// Areas up to this are rounding (a perimeter of 1 km on the grid of 1e-6 m), m².
inline constexpr double kNoArea_m2 = 1e-3;

/// The largest area about which a repair may decide, m²; beyond it, the decision would be a guess.
inline double guess_limit_m2(double area_m2) { return std::max(1.0, 1e-3 * area_m2); }

}  // namespace tramline
