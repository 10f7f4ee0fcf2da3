#pragma once
// What counts as nothing along and across a track. What one algorithm alone needs stands with it.

#include "tramline/decomposition/tolerances.h"
#include "tramline/geometry/tolerances.h"

namespace tramline {

/// Cross-sections shorter than this count as none, and ones short of the full width by no more as
/// full, m: ten times what the precision grid can move an edge that should lie on a strip line, so that
/// such an edge neither cuts a row nor makes one.
inline constexpr double kWidthTolerance = 1e-5;

/// A piece that goes all round ends this far before its beginning, m: a piece has two ends.
inline constexpr double kOpening_m = 1e-5;

/// A stretch shorter than this is nothing, m: a detour may begin where its stretch does, and two passable
/// obstacles may all but touch.
inline constexpr double kNoPiece_m = 1e-3;

/// How far beyond its end is looked for what a piece stops at, m.
inline constexpr double kLookAhead_m = 1e-3;

/// Edges within this angle of the direction are parallel to it, rad.
inline constexpr double kParallelRadians = 1e-6;

/// Of a length: edges as long as the longest but for this are as long.
inline constexpr double kSameLength_share = 1e-6;

// The grid does not show in widths, and widths do not show in lengths.
static_assert(kWidthTolerance >= 10 * kGridSize && kWidthTolerance < kNoPiece_m);
// Chords stay within the tolerance of widths, and a stretch is longer than what chords are off.
static_assert(kChordSagitta <= kWidthTolerance && kLayerSagitta < kNoPiece_m);
// A stretch of a parallel that is kept is long enough for a piece.
static_assert(kShortestStretch_m >= kNoPiece_m);
// The opening has a length, and nobody takes it for a break in the work.
static_assert(kShortest_m < kOpening_m && kOpening_m < kNoPiece_m);
// What lies behind the next piece is not looked for.
static_assert(kLookAhead_m <= kNoPiece_m && kLookAhead_m > kWidthTolerance);
// The edge that a direction comes from is parallel to it.
static_assert(kSameDirectionRadians <= kParallelRadians);

}  // namespace tramline
