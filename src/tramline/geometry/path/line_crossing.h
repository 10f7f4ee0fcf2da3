#pragma once
// Crossings of a polyline with itself and of two segments.

#include <optional>
#include <utility>
#include <vector>

#include "tramline/geometry/point.h"

namespace tramline {

/// The first two edges of a polyline, not neighbours, that have a point in common, as the indices of their
/// first vertices, the lesser one first. Precondition: no two consecutive vertices coincide. O(n log n) for
/// lines whose edges do not crowd.
std::optional<std::pair<std::size_t, std::size_t>> self_crossing(const std::vector<Point>& line);

/// Share of ab (0 at a, 1 at b) at which the segment cd crosses it; nullopt where it does not, or runs beside
/// it.
std::optional<double> crossing_along(Point a, Point b, Point c, Point d);

}  // namespace tramline
