#pragma once
// What a box shows of a line.

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

struct PlaceOnLine {
  Point at;
  Point along;  ///< unit vector
};
/// The place so far along the line; its end where it is shorter. Precondition: two points or more that
/// differ.
PlaceOnLine place_along(const std::vector<Point>& line, double run);

}  // namespace tramline::render
