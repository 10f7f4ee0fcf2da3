#pragma once
// Tolerances of the distance that detours keep and of the cost that they save. Tolerances of a single
// algorithm stand with it.

#include "tramline/geometry/tolerances.h"
#include "tramline/tracks/tolerances.h"

namespace tramline {

/// Costs that differ by no more are equal: smaller savings are rounding.
inline constexpr double kRounding_cost = 1e-9;

/// Largest loss of a distance to the width tolerance, rounding and the precision grid, m.
inline constexpr double kClearanceSlack_m = 2e-5;
/// Slack that a bound grants to detours, m: more than detours themselves get.
inline constexpr double kBoundSlack_m = 1e-3;
/// Tips of hazards thinner than the width tolerance lie outside the gap; they are no longer than this, m.
inline constexpr double kTip_m = 0.01;

// A detour that only rounding brings nearer is not refused, and none is found that the bound excludes.
static_assert(kClearanceSlack_m >= kWidthTolerance + kGridSize && kClearanceSlack_m < kBoundSlack_m);
// A tip is longer than a stretch that is no piece.
static_assert(kNoPiece_m < kTip_m);

}  // namespace tramline
