#pragma once
// Tolerances along and across a track. Tolerances of a single algorithm stand with it.

#include "tramline/decomposition/tolerances.h"
#include "tramline/geometry/tolerances.h"

namespace tramline {

/// Shorter cross-sections count as empty, and those short of the full width by no more as full, m: ten times
/// the largest move by the precision grid of an edge that should lie on a strip line, so that such an edge
/// neither cuts a row nor makes one.
inline constexpr double kWidthTolerance = 1e-5;

/// A piece that goes all round ends this far before its beginning, m: a piece has two ends.
inline constexpr double kOpening_m = 1e-5;

/// A shorter stretch is no piece, m: a detour may begin where its stretch does, and two passable obstacles
/// may nearly touch.
inline constexpr double kNoPiece_m = 1e-3;

/// Feet of a point on a polyline whose distances from the point differ by no more are all its feet, m:
/// vertices of pieces are rounded to the precision grid, which changes a distance by less.
inline constexpr double kEquidistant_m = 2e-6;

/// Length beyond a piece's end that is searched for what it stops at, m.
inline constexpr double kLookAhead_m = 1e-3;

/// Edges within this angle of the direction are parallel to it, rad.
inline constexpr double kParallelRadians = 1e-6;

/// Relative to a length: edges shorter than the longest by no more count as equally long.
inline constexpr double kSameLength_share = 1e-6;

// The precision grid is within the tolerance of widths, and that within the tolerance of lengths.
static_assert(kWidthTolerance >= 10 * kGridSize && kWidthTolerance < kNoPiece_m);
// Chords deviate by no more than the tolerance of widths, and a stretch is longer than their deviation.
static_assert(kChordSagitta <= kWidthTolerance && kLayerSagitta < kNoPiece_m);
// Vertices on the precision grid are as near as they were meant to be.
static_assert(kEquidistant_m > kGridSize && kEquidistant_m < kWidthTolerance);
// A stretch of a parallel that is kept is long enough for a piece.
static_assert(kShortestStretch_m >= kNoPiece_m);
// The opening has a length and is too short for a break in the work.
static_assert(kShortest_m < kOpening_m && kOpening_m < kNoPiece_m);
// The search does not reach beyond the next piece.
static_assert(kLookAhead_m <= kNoPiece_m && kLookAhead_m > kWidthTolerance);
// The edge that a direction comes from is parallel to it.
static_assert(kSameDirectionRadians <= kParallelRadians);

}  // namespace tramline
