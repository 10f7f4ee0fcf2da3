#pragma once
// Vertices of a polyline far enough apart for an arc at each.

#include <cstddef>
#include <vector>

#include "tramline/geometry/point.h"

namespace tramline {

/// Turns sharper than this are hairpins, rad: an arc there would cut off eleven times its radius.
inline constexpr double kSharpestTurn = 170 * 3.14159265358979323846 / 180;

/// How far the line abc turns at b, left positive, rad; in [−π, π]. Precondition: a != b != c.
double turn_at(Point a, Point b, Point c);

/// Moves and merges vertices until on every edge there is room for the tangents of arcs of `radius_m` at
/// both its ends, each radius·tan(|turn|/2) long; see smoothed(). First and last vertex stay.
/// `names` are the vertices' numbers in the user's line. Throws Error(kBadInput) where a hairpin is
/// tighter than can be driven. Precondition: at least two points, none like its neighbour. O(n log n).
std::vector<Point> merged_kinks(const std::vector<Point>& line, const std::vector<std::size_t>& names,
                                double radius_m);

}  // namespace tramline
