#pragma once
// Tolerances of the geometry: which points, distances and headings count as equal, and how far chords may
// deviate from arcs. Tolerances of a single algorithm stand with it.

#include "tramline/geometry/path/path.h"

namespace tramline {

// Relative tolerances.

/// Relative, for what is computed from a number in a few steps: seven digits more than rounding takes.
inline constexpr double kRounding_share = 1e-9;
/// Relative to a radius or to a distance from a path: the precision lost by a path whose ends lie on the
/// precision grid or come from a file.
inline constexpr double kPathRadius_share = 1e-6;

// Tolerances of lengths. The coordinates of large fields are exact to 1e-10 m.

/// A shorter length has no direction and is no part of a path, m: it would be mostly rounding.
inline constexpr double kShortest_m = 1e-9;
/// Distances that differ by no more are equal, m: a few times the rounding. A much larger value would leave
/// slivers of the offset front, to which no corner leads, where parallels nearly touch.
inline constexpr double kSameDistance_m = 1e-9;
/// A point that is no farther from a curve, or beyond its end, is on it, m: the rounding of one crossing.
inline constexpr double kTouch_m = 1e-9;
/// Crossings of offset curves that are no farther apart are one node, m: each is inexact by up to kTouch_m,
/// and more where curves meet at a small angle.
inline constexpr double kSameNode_m = 1e-8;
/// Positions along a path that differ by no more are the same foot point of an offset front, m: a crossing of
/// two parallels is computed on either of them.
inline constexpr double kSameFoot_m = 1e-7;
/// A shorter straight part between two arcs is left out, m: the rounding of its ends would turn its heading.
inline constexpr double kShortestStraight_m = 1e-7;
/// Spacing of the precision grid, m. A vertex moves at most kGridSize/√2, so an area changes by at
/// most about kGridSize · perimeter.
inline constexpr double kGridSize = 1e-6;

/// Vertices no farther than this from a ring through the others do not count as corners when it is offset
/// with mitres, m: on the precision grid collinear vertices are no longer, and their kinks would grow into
/// notches.
inline constexpr double kMitredIdle_m = 1e-5;
static_assert(kMitredIdle_m >= 10 * kGridSize);
/// Points nearer to one another are one, m: the error of the precision grid, and the rounding of coordinates
/// given to 1e-11 degrees. Far below what any receiver measures.
inline constexpr double kSamePlace_m = 1e-6;
/// Branches of a front whose ends are no farther apart meet there, m: they run up to the crossing at a small
/// angle, and their ends are inexact by many times the error of the crossing.
inline constexpr double kFrontsMeet_m = 1e-5;
/// Shorter stretches of parallels are dropped, m: nobody drives a millimetre.
inline constexpr double kShortestStretch_m = 1e-3;
/// Straight part kept between arcs that are moved apart, m: a part of a few nanometres has no direction.
inline constexpr double kLeastBetweenArcs_m = 1e-3;
/// A position that is no farther beyond the end of a path means the end, m: callers add positions up and
/// round them to a grid.
inline constexpr double kBeyondEnd_m = 1e-3;
/// Least width and height of a grid of cells, m: all boxes may be one point.
inline constexpr double kLeastGridSide_m = 1e-9;
/// The shorter side of such a grid is at least this share of its longer one, which bounds the number of
/// cells.
inline constexpr double kFlattestGrid_share = 1e-3;

// Tolerances of areas.

/// Centres of arcs whose squared distance is no larger are one, m²: the square of kTouch_m.
inline constexpr double kConcentric_m2 = 1e-18;
/// A smaller area left open in the middle of a closed band is no hole, m²: rounding along a perimeter of 1
/// km.
inline constexpr double kNoHole_m2 = 1e-3;

// Tolerances of headings, where the sine of a small angle is the angle.

/// Offset curves along lines that turn by no more have no crossing that could be computed, rad.
inline constexpr double kParallelCurves_rad = 1e-13;
/// Branches of a front along lines that turn by no more are not cut, rad.
inline constexpr double kParallelBranches_rad = 1e-12;
/// Segments that turn by no more against one another go straight on, rad.
inline constexpr double kLeastKink_rad = 1e-9;
/// Pieces of an offset line that leave a node in headings that differ by no more leave it in the same
/// heading, rad: the width of a node turns a piece of a decimetre by so much.
inline constexpr double kSameHeading_rad = 1e-7;
/// Where edges of a boundary turn by less, the lines along them go on without an arc, rad: an arc about the
/// corner would be a few micrometres long.
inline constexpr double kNoCorner_rad = 5e-7;
/// Where two branches of a front meet, the front turns to the right, or to the left by no more than this,
/// rad: the headings of two branches that touch differ by rounding.
inline constexpr double kFrontCorner_rad = 1e-6;
/// A turn that differs from half a turn by no more may be to either side, and its arc has no middle between
/// its end headings, rad.
inline constexpr double kHalfTurn_rad = 1e-6;
/// A piece of an offset line that goes straight back to within this counts as turning to the left, rad: the
/// width of a node turns a piece of a tenth of a millimetre by so much.
inline constexpr double kStraightBack_rad = 1e-4;

// Largest distances between arcs and the chords that replace them, besides kChordSagitta.

/// In layers that show where land is worked twice or not at all, m: pictures of the tally, for which polygon
/// booleans need not carry three times as many vertices.
inline constexpr double kLayerSagitta = 1e-4;
/// Where meetings of a line with arcs, or distances from arcs, are computed, m.
inline constexpr double kMeasuredSagitta_m = 1e-4;
/// Where a path is only tested for crossing itself, m.
inline constexpr double kCrossedSagitta_m = 1e-3;

// Crossings are less exact than the distances they are computed from, positions along a path less exact than
// crossings, and all of them more exact than the precision grid.
static_assert(kSameDistance_m <= kTouch_m && kTouch_m < kSameNode_m);
static_assert(kShortest_m <= kSameNode_m && kSameNode_m < kSameFoot_m && kSameFoot_m < kGridSize);
static_assert(kSameFoot_m < kFrontsMeet_m && kFrontsMeet_m < kShortestStretch_m);
// Two centres that are kTouch_m apart are one.
static_assert(kConcentric_m2 >= 0.999 * kTouch_m * kTouch_m && kConcentric_m2 <= 1.001 * kTouch_m * kTouch_m);
// A straight part left out of a smoothed line is longer than a length without direction, and a part kept
// between arcs is longer than one left out.
static_assert(kShortest_m < kShortestStraight_m && kShortestStraight_m < kLeastBetweenArcs_m);
// Vertices that the grid has moved are still one point, and the deviation of chords exceeds the grid.
static_assert(kGridSize <= kSamePlace_m && kGridSize < kChordSagitta);
// Pictures have coarser chords than computed figures, and no stretch is lost between chord and arc.
static_assert(kChordSagitta < kLayerSagitta && kLayerSagitta < kShortestStretch_m);
static_assert(kLayerSagitta <= kMeasuredSagitta_m && kMeasuredSagitta_m < kCrossedSagitta_m);
// The tolerances of angles are in increasing order.
static_assert(kParallelCurves_rad < kParallelBranches_rad && kParallelBranches_rad < kLeastKink_rad);
static_assert(kLeastKink_rad < kSameHeading_rad && kSameHeading_rad < kNoCorner_rad);
static_assert(kNoCorner_rad < kFrontCorner_rad && kFrontCorner_rad <= kHalfTurn_rad);
static_assert(kHalfTurn_rad < kStraightBack_rad);
// The tolerance for rounding is within that for the precision grid.
static_assert(kRounding_share < kPathRadius_share);

}  // namespace tramline
