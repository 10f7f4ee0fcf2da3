#pragma once
// Tolerances of the decomposition for directions, lines and areas.

#include "tramline/geometry/tolerances.h"

namespace tramline {

/// A turned direction may exceed a limit by this and still count as within it, rad: rounding.
inline constexpr double kInclusive_rad = 1e-9;
/// Directions closer than this are one, rad: over a kilometre they diverge by a millimetre.
inline constexpr double kSameDirectionRadians = 1e-6;
/// Rays that turn from an edge by no more follow it, rad.
inline constexpr double kAlongEdge_rad = 2e-6;

/// A cut that passes a vertex nearer than this ends there, m: what would be a sliver is one line.
inline constexpr double kSameLine = 1e-6;

/// Relative to a polygon's area: parts whose areas sum to less or more by this are not its parts.
inline constexpr double kSameArea_share = 1e-7;

// The sweep may differ from the edge it comes from by kSameDirectionRadians and still follows it.
static_assert(kInclusive_rad < kSameDirectionRadians && kSameDirectionRadians < kAlongEdge_rad);
// A cut ends at the vertex that the precision grid would make it end at.
static_assert(kSameLine >= kGridSize && kSameLine <= kSamePlace_m);
// Rounding alone does not make the sum of the parts fall short.
static_assert(kSameArea_share > kRounding_share);

}  // namespace tramline
