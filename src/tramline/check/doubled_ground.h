#pragma once
// Where more than one swath works.

#include "tramline/geometry/region.h"

namespace tramline::check {

/// Land thinner than this is rounding: maps do not show it, and nobody asks for it. m
inline constexpr double kThinnestShown_m = 1e-5;

/// What any two of the polygons have in common, pair by pair, but for what is thinner than kThinnestShown_m:
/// where three lie over one another these parts do, too. Every polygon has to be valid.
/// O(n·log n + k) for k pairs whose boxes meet.
Region doubled_ground(const Region& swaths);

}  // namespace tramline::check
