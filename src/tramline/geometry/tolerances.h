#pragma once
// What counts as one place, one distance or one heading in the geometry, and how far chords may be off arcs.
// What one algorithm alone needs stands with it.

#include "tramline/geometry/path/path.h"

namespace tramline {

// Of numbers.

/// Of a number, for what is computed from it in a few steps: seven digits more than rounding takes.
inline constexpr double kRounding_share = 1e-9;
/// Of a radius or of a distance from a path, for what a path has lost whose ends lie on the precision grid or
/// come from a file.
inline constexpr double kPathRadius_share = 1e-6;

// Of lengths. Coordinates of large fields have 1e-10 m.

/// What is shorter has no direction, and is no part of a path, m: it would be mostly rounding.
inline constexpr double kShortest_m = 1e-9;
/// Distances that differ by no more are equal, m: rounding a few times over. Much more, and where parallels
/// all but touch there would be slivers of front that no corner leads to.
inline constexpr double kSameDistance_m = 1e-9;
/// A place as near to a curve, or as little beyond its end, is on it, m: the rounding of one crossing.
inline constexpr double kTouch_m = 1e-9;
/// Crossings of offset curves as near to one another are one node, m: each is off by up to a touch, and more
/// where curves meet at a small angle.
inline constexpr double kSameNode_m = 1e-8;
/// Places along a path as near to one another are one, where fronts put their feet, m: a crossing of two
/// parallels seen from either of them.
inline constexpr double kSameFoot_m = 1e-7;
/// A straight part between two arcs that is shorter is left out, m: its ends alone would turn its heading.
inline constexpr double kShortestStraight_m = 1e-7;
/// Spacing of the precision grid, m. A vertex moves at most kGridSize/√2, so an area changes by at
/// most about kGridSize · perimeter.
inline constexpr double kGridSize = 1e-6;
/// Places nearer to one another are one, m: what the precision grid makes of one, and the rounding of
/// coordinates given to 1e-11 degrees. Far below what any receiver measures.
inline constexpr double kSamePlace_m = 1e-6;
/// Branches of a front whose ends come as near meet there, m: they run up to the crossing at a small angle,
/// and the places where they end are off by many times what the crossing is.
inline constexpr double kFrontsMeet_m = 1e-5;
/// Stretches of parallels that are shorter are nothing, m: nobody drives a millimetre.
inline constexpr double kShortestStretch_m = 1e-3;
/// Left straight between arcs that are drawn apart, m: a part of a few nanometres has no direction.
inline constexpr double kLeastBetweenArcs_m = 1e-3;
/// A place asked for as little beyond the ends of a path means the end, m: what callers add up, and have
/// rounded to a grid.
inline constexpr double kBeyondEnd_m = 1e-3;
/// Width and height of what is sorted into a grid of cells are at least that, m: all boxes may be one point.
inline constexpr double kLeastGridSide_m = 1e-9;
/// Cells of such a grid are no flatter than this share of its longer side, which bounds how many there are.
inline constexpr double kFlattestGrid_share = 1e-3;

// Of areas.

/// Centres of arcs whose distance has no larger square are one, m²: kTouch_m as the square of a distance.
inline constexpr double kConcentric_m2 = 1e-18;
/// What a closed band leaves open in its middle is no hole if it is smaller, m²: rounding along a perimeter
/// of 1 km.
inline constexpr double kNoHole_m2 = 1e-3;

// Of headings, where the sine of a small angle is the angle.

/// Offset curves along lines that turn by no more have no crossing that could be computed, rad.
inline constexpr double kParallelCurves_rad = 1e-13;
/// Branches of a front along lines that turn by no more are not cut, rad.
inline constexpr double kParallelBranches_rad = 1e-12;
/// Segments that turn by no more go straight on, rad.
inline constexpr double kLeastKink_rad = 1e-9;
/// Pieces of a level that leave a node in headings that differ by no more leave it in one, rad: by so much
/// the width of a node turns a piece of a decimetre.
inline constexpr double kSameHeading_rad = 1e-7;
/// Where edges of a shore turn by less, the lines along them just go on, rad: an arc about the corner would
/// be a few micrometres long.
inline constexpr double kNoCorner_rad = 5e-7;
/// Where two branches of a front meet, it turns to the right, or to the left by no more than this, rad: the
/// headings of two branches that touch differ by rounding.
inline constexpr double kFrontCorner_rad = 1e-6;
/// A turn that is half a turn but for this may be one to either side, and the arc that does it has no middle
/// between its end headings, rad.
inline constexpr double kHalfTurn_rad = 1e-6;
/// A piece of a level that goes straight back, but for this, counts as turning to the left, rad: by so much
/// the width of a node turns a piece of a tenth of a millimetre.
inline constexpr double kStraightBack_rad = 1e-4;

// How far chords may be off the arcs they stand for, beside kChordSagitta.

/// The same in layers that show where land is worked twice or not at all: pictures of the tally, for
/// which polygon booleans need not carry three times as many vertices, m.
inline constexpr double kLayerSagitta = 1e-4;
/// The same where meetings of a line with arcs, or distances from them, are asked, m.
inline constexpr double kMeasuredSagitta_m = 1e-4;
/// The same where only is asked whether a path crosses itself, m.
inline constexpr double kCrossedSagitta_m = 1e-3;

// Crossings are off by more than the distances they are computed from, places along a path by more than
// crossings, and all of them by less than what the precision grid moves a vertex.
static_assert(kSameDistance_m <= kTouch_m && kTouch_m < kSameNode_m);
static_assert(kShortest_m <= kSameNode_m && kSameNode_m < kSameFoot_m && kSameFoot_m < kGridSize);
static_assert(kSameFoot_m < kFrontsMeet_m && kFrontsMeet_m < kShortestStretch_m);
// Two centres that are a touch apart are one.
static_assert(kConcentric_m2 >= 0.999 * kTouch_m * kTouch_m && kConcentric_m2 <= 1.001 * kTouch_m * kTouch_m);
// What is left out of smoothed lines is longer than what has no direction, and what is drawn apart longer
// than what is left out.
static_assert(kShortest_m < kShortestStraight_m && kShortestStraight_m < kLeastBetweenArcs_m);
// Vertices that the grid has moved are still at one place, and chords do not hide in it.
static_assert(kGridSize <= kSamePlace_m && kGridSize < kChordSagitta);
// Pictures have coarser chords than figures, and no stretch is lost between chord and arc.
static_assert(kChordSagitta < kLayerSagitta && kLayerSagitta < kShortestStretch_m);
static_assert(kLayerSagitta <= kMeasuredSagitta_m && kMeasuredSagitta_m < kCrossedSagitta_m);
// An angle is one the sooner, the less rests on it.
static_assert(kParallelCurves_rad < kParallelBranches_rad && kParallelBranches_rad < kLeastKink_rad);
static_assert(kLeastKink_rad < kSameHeading_rad && kSameHeading_rad < kNoCorner_rad);
static_assert(kNoCorner_rad < kFrontCorner_rad && kFrontCorner_rad <= kHalfTurn_rad);
static_assert(kHalfTurn_rad < kStraightBack_rad);
// What rounding has changed is within what the grid may have changed.
static_assert(kRounding_share < kPathRadius_share);

}  // namespace tramline
