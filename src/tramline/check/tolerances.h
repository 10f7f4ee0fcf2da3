#pragma once
// How far a plan may be from the exact definitions. How large it may be stands in model/limits.h.

#include "tramline/model/limits.h"

namespace tramline::check {

/// Along and across a piece, m: what no machine can tell.
inline constexpr double kLengthTolerance_m = 1e-3;
/// Between the end of a segment of a path and the beginning of the next, m: the precision grid's.
inline constexpr double kJoint_m = 1e-6;
/// What is shorter has no direction, m.
inline constexpr double kShortest_m = 1e-9;
/// Of a radius, and of a heading: what a path computed in another way than it is checked may lose.
inline constexpr double kRadiusShare = 0.01;
inline constexpr double kHeadingTolerance_deg = 1;
/// How far the chords that stand for round edges of headlands may be off them, m.
inline constexpr double kRoundEdge_m = 1e-3;
/// How far chords may be off a path of which only the sides are asked, m.
inline constexpr double kSideSagitta_m = 1e-4;
/// Area of the smallest overlap that counts as one, m²: five micrometres over a millimetre, above what the
/// precision grid can move an edge.
inline constexpr double kTouch_m2 = 5e-9;
/// Land thinner than this along a whole swath is none, m: well below the spacing of the precision grid.
inline constexpr double kThinnestLand_m = 1e-7;
/// Of an area, for the difference of it and one as large.
inline constexpr double kAreaRounding = 1e-12;
/// Of the field's area, for sums of areas.
inline constexpr double kAreaShare = 1e-6;

}  // namespace tramline::check
