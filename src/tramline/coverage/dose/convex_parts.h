#pragma once
// The convex polygons of a quad, in floating point.

#include <array>
#include <cstddef>
#include <vector>

#include "tramline/coverage/drive/worked_step.h"

namespace tramline::coverage {

/// A convex polygon of few corners, counter-clockwise.
struct SmallPolygon {
  static constexpr std::size_t kMost = 12;  ///< a quad cut by four lines has eight
  std::array<Point, kMost> corners;
  std::size_t size = 0;

  void add(Point p) { corners[size++] = p; }
};

double area(const SmallPolygon& polygon);

/// The quad itself where it is convex, two triangles where it is an arrow or crosses itself, in either
/// orientation. Parts do not overlap, and may have no area. O(1).
std::vector<SmallPolygon> convex_parts(const Quad& quad);

}  // namespace tramline::coverage
