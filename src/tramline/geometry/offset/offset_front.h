#pragma once
// The points at one distance from a path: the wave front that started from it.

#include <vector>

#include "tramline/geometry/interval.h"
#include "tramline/geometry/offset/contour.h"

namespace tramline {

/// A point where two branches of the front meet: one ends and the other begins.
struct OffsetCorner {
  double before = 0;  ///< positions on the contour that the corner is equally far from
  double after = 0;
  Point point;
  double turn_rad = 0;  ///< to the right, in [0, π]
};

struct OffsetFront {
  /// Positions whose normal reaches out to the distance without coming nearer to any other part of the path.
  Intervals feet;
  std::vector<OffsetCorner> corners;  ///< by `before`
};

/// The sides of the path to make the front on.
enum class Sides { kRight, kLeft, kBoth };

/// The front at a distance (> 0, m) from the path. Every branch is cut where it meets another one or a circle
/// about an end of the path, and one point of each part is tested for its distance from the path: no front is
/// derived from another one, and the only tolerance is that of being nearer (kSameDistance_m). Quarter turns
/// about the ends have no feet. About O(n log n) for n segments; O(n²) where the boxes of all parallels
/// overlap.
OffsetFront offset_front(const Contour& contour, double distance_m, Sides sides);

}  // namespace tramline
