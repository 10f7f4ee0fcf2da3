#pragma once
// What admission takes for rounding and what for a fault.

#include <algorithm>

namespace tramline {

/// Vertices closer than this are one vertex, and a spike thinner than this has no width, m. Far below what
/// any receiver measures and above the rounding of coordinates given to 1e-11 degrees.
inline constexpr double kSamePlace_m = 1e-6;

/// Areas up to this are rounding (a perimeter of 1 km on the grid of 1e-6 m), m².
inline constexpr double kNoArea_m2 = 1e-3;

/// Up to this much land a repair may decide by itself, m²; beyond it, it would be guessing.
inline double guess_limit_m2(double area_m2) { return std::max(1.0, 1e-3 * area_m2); }

}  // namespace tramline
