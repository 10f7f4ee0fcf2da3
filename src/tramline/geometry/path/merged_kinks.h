#pragma once
// Vertices of a polyline far enough apart for an arc at each.

#include <cstddef>
#include <optional>
#include <vector>

#include "tramline/geometry/point.h"

namespace tramline {

/// Turns sharper than this are hairpins, rad: an arc there would cut off eleven times its radius.
inline constexpr double kSharpestTurn = 170 * 3.14159265358979323846 / 180;

/// How far the line abc turns at b, left positive, rad; in [−π, π]. Precondition: a != b != c.
double turn_at(Point a, Point b, Point c);

/// A line with room for arcs.
struct MergedKinks {
  std::vector<Point> line;
  std::optional<std::size_t>
      hairpin;  ///< the vertex of one tighter than can be driven; the line is of no use
};

/// Moves and merges vertices until on every edge there is room for the tangents of arcs of `radius_m` at
/// both its ends, each radius·tan(|turn|/2) long; see smoothed(). First and last vertex stay.
/// Precondition: at least two points, none like its neighbour. O(n log n).
MergedKinks merged_kinks(const std::vector<Point>& line, double radius_m);

}  // namespace tramline
