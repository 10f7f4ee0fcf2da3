#pragma once
// Which directions, lines and areas are one for the decomposition.

#include "tramline/geometry/tolerances.h"

namespace tramline {

/// A turned direction may exceed a limit by this and still be within it, rad: by rounding.
inline constexpr double kInclusive_rad = 1e-9;
/// Directions closer than this are one, rad: over a kilometre they part by a millimetre.
inline constexpr double kSameDirectionRadians = 1e-6;
/// Rays that turn from an edge by no more follow it, rad.
inline constexpr double kAlongEdge_rad = 2e-6;

/// A cut that passes a vertex nearer than this ends there: what would be a sliver is one line. m
inline constexpr double kSameLine = 1e-6;

/// Of a polygon's area: parts that make up less or more are not its parts.
inline constexpr double kSameArea_share = 1e-7;

// The sweep may differ by the one from the edge it comes from, and then follows it all the same.
static_assert(kInclusive_rad < kSameDirectionRadians && kSameDirectionRadians < kAlongEdge_rad);
// A cut ends at the vertex that the precision grid would make it end at.
static_assert(kSameLine >= kGridSize && kSameLine <= kSamePlace_m);
// Rounding alone does not make parts fall short.
static_assert(kSameArea_share > kRounding_share);

}  // namespace tramline
