#pragma once
// How far a plan may be from the exact definitions, and what counts as nothing. How large a plan may be
// stands in model/limits.h. What one algorithm alone needs stands with it.

#include <numbers>

#include "tramline/geometry/path/path.h"
#include "tramline/geometry/polygon/boolean.h"
#include "tramline/geometry/tolerances.h"
#include "tramline/model/limits.h"

namespace tramline::check {

// What a plan may be off.

/// Along and across a piece, m: what no machine can tell.
inline constexpr double kLengthTolerance_m = 1e-3;
/// Of a radius, and of a heading: what a path computed in another way than it is checked may lose.
inline constexpr double kRadiusShare = 0.01;
inline constexpr double kHeadingTolerance_deg = 1;
/// Of the field's area, for sums of areas.
inline constexpr double kAreaShare = 1e-6;
/// What a file says twice may differ by, in metres or as a share: text keeps more digits, the precision grid
/// does not.
inline constexpr double kSaidTwice = 1e-6;
/// Between the end of a segment of a path and the beginning of the next, m: the precision grid's.
inline constexpr double kJoint_m = 1e-6;

// What counts as nothing.

/// Between places along a path, m: whatever changes on less is not looked at. Coordinates of large fields
/// have no more digits.
inline constexpr double kNoStretch_m = 1e-12;
/// What is shorter has no direction, and lengths that differ by less are equal, m: what the digits of
/// coordinates leave of a difference, a few times over.
inline constexpr double kShortest_m = 1e-9;
/// Of a distance between a point and an arc, m: centres of flat arcs lie far off, and lose digits.
inline constexpr double kDistanceRounding_m = 1e-7;
/// Land thinner than this along a whole swath is none, m: well below the spacing of the precision grid.
inline constexpr double kThinnestLand_m = 1e-7;
/// Land so near beside a swath touches it, m: an edge along the swath's may be off by rounding over its whole
/// length.
inline constexpr double kTouching_m = 1e-6;
/// Land thinner than this is not asked for in layers, m: maps do not show it.
inline constexpr double kThinnestShown_m = 1e-5;
/// Segments shorter than this say nothing of a heading, m: the precision grid alone could turn them by the
/// tolerance of headings.
inline constexpr double kShortestTurned_m = 1e-4;
/// Area of the smallest overlap that counts as one, m²: five micrometres over a millimetre, above what the
/// precision grid can move an edge.
inline constexpr double kTouch_m2 = 5e-9;
/// Of a number, for what is computed from it in a few steps.
inline constexpr double kRounding = 1e-9;
/// Of an area, for the difference of it and one as large: rounding grows with them.
inline constexpr double kAreaRounding = 1e-12;

// When headings are one: lengths of the difference of unit vectors, which are angles in radians.

/// Straight segments that meet at more have a kink there, and bands that are cut to it.
inline constexpr double kLeastKink = 1e-9;
/// A swath that turns by more at a point may lie over itself there.
inline constexpr double kStraightOn = 1e-6;
/// A line that turns by no more at its joints has no kinks for who follows it.
inline constexpr double kSameHeading = 1e-3;

// How far chords may be off the arcs they stand for, m. Those of plans come with geometry/path/path.h.

/// Where only the sides of a path are asked.
inline constexpr double kSideSagitta_m = 1e-4;
/// Of the corners of land near a boundary, within the tolerance for them (kRoundEdge_m).
inline constexpr double kFanSagitta_m = 1e-4;
/// Round edges of headlands.
inline constexpr double kRoundEdge_m = 1e-3;
/// Where only the sense is asked in which a closed path goes round.
inline constexpr double kSenseSagitta_m = 1e-3;

// Rounding of one place is below that of a distance from it.
static_assert(kNoStretch_m < kShortest_m && kShortest_m < kDistanceRounding_m);
// Joints and touching allow for rounding, and stay well within what a plan may be off.
static_assert(kDistanceRounding_m < kJoint_m && kJoint_m < kLengthTolerance_m);
static_assert(kThinnestLand_m < kGridSize && kGridSize <= kTouching_m && kTouching_m < kThinnestShown_m);
static_assert(kThinnestShown_m < kLengthTolerance_m);
static_assert(kTouch_m2 > kGridSize * kLengthTolerance_m);
// What a joint may be off does not turn a segment whose heading is asked.
static_assert(kJoint_m / kShortestTurned_m < kHeadingTolerance_deg * std::numbers::pi / 180);
// The finer headings are told apart, the more rests on it.
static_assert(kLeastKink < kStraightOn && kStraightOn < kSameHeading);
static_assert(kSameHeading < kHeadingTolerance_deg * std::numbers::pi / 180);
// Chords stay within what is asked of the paths they stand for.
static_assert(kChordSagitta < kSideSagitta_m && kSideSagitta_m < kLengthTolerance_m);
static_assert(kFanSagitta_m < kRoundEdge_m && kRoundEdge_m <= kLengthTolerance_m);
static_assert(kSenseSagitta_m <= kLengthTolerance_m);

}  // namespace tramline::check
