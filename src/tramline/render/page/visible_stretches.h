#pragma once
// The parts of a line inside a box.

#include <optional>
#include <utility>
#include <vector>

#include "tramline/geometry/polygon/region.h"

namespace tramline::render {

/// The part of segment ab inside the box; nullopt where it has no length.
std::optional<std::pair<Point, Point>> clipped(Point a, Point b, const Box& box);

/// The stretches of a line inside the box, in its order, each of two points or more; ends that are inside
/// stay as they are. O(n).
std::vector<std::vector<Point>> stretches_in(const std::vector<Point>& line, const Box& box);

double length_of(const std::vector<Point>& line);

struct PointOnLine {
  Point at;
  Point along;  ///< unit vector
};
/// The position at a distance along the line; its end where the line is shorter. Precondition: two points or
/// more that differ.
PointOnLine point_along(const std::vector<Point>& line, double run);

}  // namespace tramline::render
