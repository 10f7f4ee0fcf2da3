#pragma once
// Where the points at one distance from a path are: the wave front that started from it.

#include <vector>

#include "tramline/geometry/interval.h"
#include "tramline/geometry/offset/contour.h"

namespace tramline {

/// Where two branches of the front meet: one ends and the other begins.
struct OffsetCorner {
  double before = 0;  ///< places on the contour of which the corner is equally far
  double after = 0;
  Point place;
  double turn_rad = 0;  ///< to the right, in [0, π]
};

struct OffsetFront {
  /// Places whose normal reaches out to the distance without coming nearer to any other part of the path.
  Intervals feet;
  std::vector<OffsetCorner> corners;  ///< by `before`
};

/// Which sides of the path are asked for.
enum class Sides { kRight, kLeft, kBoth };

/// The front at a distance (> 0, m) from the path. Every branch is cut where it meets another one or a
/// circle about an end of the path, and of each part one point is asked how far it is from the path: no
/// front is made from another one, and no tolerance but of what counts as nearer (kSameDistance_m).
/// Quarter turns about the ends are no feet. About O(n log n) for n segments; n² where the boxes of
/// all parallels overlap.
OffsetFront offset_front(const Contour& contour, double distance_m, Sides sides);

}  // namespace tramline
