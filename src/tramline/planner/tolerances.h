#pragma once
// What counts as no ground, no gain or one place in the search. What one search alone needs, and the shares
// that tune it, stand with it.

#include "tramline/avoidance/tolerances.h"
#include "tramline/cost/tolerances.h"
#include "tramline/geometry/tolerances.h"

namespace tramline {

// Of gains.

/// Tours that are shorter by no more are as long, m: they are sums of thousands of hops.
inline constexpr double kLeastGain_m = 1e-6;
/// Repairs that save no more save nothing, of a cost: their areas come from the precision grid.
inline constexpr double kLeastGain_cost = 1e-6;
/// Lines that cover no more cover as much, m²: their areas come from the precision grid.
inline constexpr double kLeastGain_m2 = 1e-6;
/// Of a cost: divisions that save no more save nothing.
inline constexpr double kLeastSaving_share = 1e-6;

// Of lengths.

/// Width and height of a grid of places are at least that, m: all places may be one.
inline constexpr double kLeastGridOfPlaces_m = 1e-6;
/// Strips whose left edges are nearer to one another are one, m: the lines over them work the
/// same ground.
inline constexpr double kSameStrip_m = 1e-4;
/// What is left open of a chain that goes all the way round, m: a line must not touch itself.
inline constexpr double kSeam_m = 1e-3;
/// Pieces that are nearer to what blocks their track by no more are as near, m: less is rounding.
inline constexpr double kAsNear_m = 1e-3;
/// Narrower ground than this, across the strip, is not what a piece is driven for, m: the tails of a gap
/// between two passes that all but touch.
inline constexpr double kTail_m = 0.05;

// Of areas.

/// Smaller polygons are what the precision grid makes of two edges that should be one, m².
inline constexpr double kNoGround_m2 = 1e-4;
/// Less of a gap is worked by chance, m², where a swath runs over it to another.
inline constexpr double kByChance_m2 = 0.01;

// What is computed from areas is off by more than what is computed from lengths.
static_assert(kRounding_cost < kLeastGain_cost && kNoOverlap_m2 < kLeastGain_m2);
// A gain is smaller than the ground it is made on.
static_assert(kLeastGain_m2 < kNoGround_m2 && kNoGround_m2 < kByChance_m2);
// Strips that are one differ by no more than nothing does, and by more than the precision grid alone makes.
static_assert(kSamePlace_m < kSameStrip_m && kSameStrip_m < kNoPiece_m);
// The seam is left by the smoothing of the line.
static_assert(kSeam_m > kSamePlace_m && kSeam_m >= kShortestStretch_m);
// A detour may begin where its stretch does.
static_assert(kAsNear_m >= kNoPiece_m);
// The tails of gaps are wider than what counts as no width.
static_assert(kTail_m > kWidthTolerance);

}  // namespace tramline
