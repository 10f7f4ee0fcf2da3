#pragma once
// Merging of a polyline's vertices until they are far enough apart for an arc at each.

#include <cstddef>
#include <optional>
#include <vector>

#include "tramline/geometry/point.h"

namespace tramline {

/// Turns sharper than this are hairpins, rad: an arc there would cut off eleven times its radius.
inline constexpr double kSharpestTurn = 170 * 3.14159265358979323846 / 180;

/// Turn of the line abc at b, left positive, rad; in [−π, π]. Precondition: a != b != c.
double turn_at(Point a, Point b, Point c);

/// A line with room for arcs.
struct MergedKinks {
  std::vector<Point> line;
  std::optional<std::size_t> hairpin;  ///< vertex of a hairpin too tight to drive; the line is then unusable
};

/// Moves and merges vertices until every edge has room for the tangents of arcs of `radius_m` at both its
/// ends, each radius·tan(|turn|/2) long; see smoothed(). First and last vertex stay. Precondition: at least
/// two points, no two consecutive ones equal. O(n log n).
MergedKinks merged_kinks(const std::vector<Point>& line, double radius_m);

}  // namespace tramline
