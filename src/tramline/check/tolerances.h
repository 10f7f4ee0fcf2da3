#pragma once
// Tolerances of the verifier: how far a plan may deviate from the exact definitions, and what counts as zero.
// Limits on the size of a plan are in model/limits.h. Constants that only one algorithm needs are defined
// there.

#include <numbers>

#include "tramline/geometry/path/path.h"
#include "tramline/geometry/polygon/boolean.h"
#include "tramline/geometry/tolerances.h"
#include "tramline/model/limits.h"

namespace tramline::check {

// Permitted deviations of a plan.

/// Along and across a piece, m: too small to matter to any machine.
inline constexpr double kLengthTolerance_m = 1e-3;
/// Of a radius (as a share) and of a heading: the possible error of a path that is computed in another way
/// than it is checked.
inline constexpr double kRadiusShare = 0.01;
inline constexpr double kHeadingTolerance_deg = 1;
/// Of the field's area, for sums of areas.
inline constexpr double kAreaShare = 1e-6;
/// Difference of two copies of a value in a file, in metres or as a share: the precision grid keeps fewer
/// digits than text.
inline constexpr double kSaidTwice = 1e-6;
/// Gap between the end of a segment of a path and the beginning of the next, m: that of the precision grid.
inline constexpr double kJoint_m = 1e-6;
/// Outlines are looked at in places so far apart, m, and may leave the land by the second, which they do
/// unseen between two of these.
inline constexpr double kPoses_m = 0.05;
inline constexpr double kOutside_m = 0.005;
/// Of times and of the rate of steering, as a share.
inline constexpr double kTimeShare = 1e-6;

// What counts as zero.

/// Distance between positions along a path, m: changes on a shorter stretch are ignored, because coordinates
/// of large fields have no more digits.
inline constexpr double kNoStretch_m = 1e-12;
/// A shorter segment has no direction, and lengths that differ by less are equal, m: a few times the rounding
/// of a difference of coordinates.
inline constexpr double kShortest_m = 1e-9;
/// Rounding of a distance between a point and an arc, m: centres of flat arcs lie far off and lose digits.
inline constexpr double kDistanceRounding_m = 1e-7;
/// Land thinner than this along a whole swath does not count, m: well below the spacing of the precision
/// grid.
inline constexpr double kThinnestLand_m = 1e-7;
/// Land this near to a swath touches it, m: an edge along the swath's edge may be off by rounding over its
/// whole length.
inline constexpr double kTouching_m = 1e-6;
/// Land thinner than this may be missing in layers, m: maps do not show it.
inline constexpr double kThinnestShown_m = 1e-5;
/// Segments shorter than this have no reliable heading, m: the precision grid alone could turn them by the
/// tolerance of headings.
inline constexpr double kShortestTurned_m = 1e-4;
/// Area of the smallest overlap that counts as one, m²: five micrometres over a millimetre, more than the
/// precision grid can shift an edge.
inline constexpr double kTouch_m2 = 5e-9;
/// Relative rounding of a number computed in a few steps.
inline constexpr double kRounding = 1e-9;
/// Rounding of the difference of two areas, relative to their size.
inline constexpr double kAreaRounding = 1e-12;

// Differences of headings that count as zero: lengths of the difference of unit vectors, which are angles in
// radians.

/// Straight segments that meet at more have a kink there, to which their bands are cut.
inline constexpr double kLeastKink = 1e-9;
/// A swath that turns by more at a point may lie over itself there.
inline constexpr double kStraightOn = 1e-6;
/// A line that turns by no more at its joints counts as free of kinks for tracks that follow it.
inline constexpr double kSameHeading = 1e-3;

// Distances of chords from the arcs they stand for, m. That of plans is defined in geometry/path/path.h.

/// Where only the sides of a path matter.
inline constexpr double kSideSagitta_m = 1e-4;
/// At corners of land near a boundary, within the tolerance for these (kRoundEdge_m).
inline constexpr double kFanSagitta_m = 1e-4;
/// At round edges of headlands.
inline constexpr double kRoundEdge_m = 1e-3;
/// Where only the sense of rotation of a closed path matters.
inline constexpr double kSenseSagitta_m = 1e-3;

// The rounding of a position is less than that of a distance from it.
static_assert(kNoStretch_m < kShortest_m && kShortest_m < kDistanceRounding_m);
// The tolerances of joints and touching exceed rounding, and stay well within the permitted deviations.
static_assert(kDistanceRounding_m < kJoint_m && kJoint_m < kLengthTolerance_m);
static_assert(kThinnestLand_m < kGridSize && kGridSize <= kTouching_m && kTouching_m < kThinnestShown_m);
static_assert(kThinnestShown_m < kLengthTolerance_m);
static_assert(kTouch_m2 > kGridSize * kLengthTolerance_m);
// The tolerance of a joint cannot turn a segment whose heading is checked.
static_assert(kJoint_m / kShortestTurned_m < kHeadingTolerance_deg * std::numbers::pi / 180);
// The more depends on a difference of headings, the smaller its limit.
static_assert(kLeastKink < kStraightOn && kStraightOn < kSameHeading);
static_assert(kSameHeading < kHeadingTolerance_deg * std::numbers::pi / 180);
// Chords stay within the tolerances of the paths they stand for.
static_assert(kChordSagitta < kSideSagitta_m && kSideSagitta_m < kLengthTolerance_m);
static_assert(kFanSagitta_m < kRoundEdge_m && kRoundEdge_m <= kLengthTolerance_m);
static_assert(kSenseSagitta_m <= kLengthTolerance_m);

}  // namespace tramline::check
