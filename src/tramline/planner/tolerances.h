#pragma once
// Tolerances of the search: below them areas and gains count as zero and positions as equal. Constants that
// only one search needs, and the shares that tune it, are defined there.

#include "tramline/avoidance/tolerances.h"
#include "tramline/cost/tolerances.h"
#include "tramline/geometry/tolerances.h"

namespace tramline {

// Tolerances of gains.

/// The least saving of a repair, in units of cost: its areas come from the precision grid.
inline constexpr double kLeastGain_cost = 1e-6;
/// Covered areas of lines that differ by no more count as equal, m²: they come from the precision grid.
inline constexpr double kLeastGain_m2 = 1e-6;
/// The least saving of a division, as a share of the cost.
inline constexpr double kLeastSaving_share = 1e-6;

// Tolerances of lengths.

/// Strips whose left edges are nearer to one another count as one, m: the lines over them work the same land.
inline constexpr double kSameStrip_m = 1e-4;
/// The opening of a chain that goes all the way round, m: a line must not touch itself.
inline constexpr double kSeam_m = 1e-3;
/// The distance of chords from arcs of given lines that are too tight for the width, m: their swaths lie over
/// themselves, the more often the more chords there are.
inline constexpr double kTightSagitta_m = 0.01;
/// A given line that ends where it begins is shortened by this, m: a piece has two ends.
inline constexpr double kOpenedRing_m = 1e-4;
/// Distances of pieces from what blocks their track that differ by no more count as equal, m: the difference
/// is rounding.
inline constexpr double kAsNear_m = 1e-3;
/// Land narrower than this across the strip does not make a piece worthwhile, m: the tails of a gap between
/// two passes that all but touch.
inline constexpr double kTail_m = 0.05;

// Tolerances of headings.

/// Where segments of a given line with arcs meet at more, its swath has no smooth edges, rad: tracks of plan
/// files are more exact.
inline constexpr double kLeastTurnAtJoint = 1e-3;

// Tolerances of areas.

/// Smaller polygons count as nothing, m²: the precision grid makes them of two edges that should be one.
inline constexpr double kNoGround_m2 = 1e-4;
/// A smaller area of a gap is worked by chance, m², by a swath that runs over it to another gap.
inline constexpr double kByChance_m2 = 0.01;

// Values computed from areas are less exact than values computed from lengths.
static_assert(kRounding_cost < kLeastGain_cost && kNoOverlap_m2 < kLeastGain_m2);
// The least gain is smaller than the least area.
static_assert(kLeastGain_m2 < kNoGround_m2 && kNoGround_m2 < kByChance_m2);
// Strips that count as one differ by more than the precision grid alone moves them, and by less than the
// least piece.
static_assert(kSamePlace_m < kSameStrip_m && kSameStrip_m < kNoPiece_m);
// The seam has to survive the smoothing of the line.
static_assert(kSeam_m > kSamePlace_m && kSeam_m >= kShortestStretch_m);
// A ring stays open when it is read again.
static_assert(kOpenedRing_m > kSamePlace_m);
// A detour may begin at the beginning of its stretch.
static_assert(kAsNear_m >= kNoPiece_m);
// The tails of gaps are wider than what counts as no width.
static_assert(kTail_m > kWidthTolerance);

}  // namespace tramline
