#pragma once
// The contour of a path: along its right side, about its end, back along its left side, about its start. It
// has the path on its left and the plane on its right: one side to work on instead of two, so that the fronts
// of both sides may meet.

#include <cassert>
#include <cstddef>
#include <vector>

#include "tramline/geometry/path/path.h"
#include "tramline/geometry/tolerances.h"

namespace tramline {

/// A segment of the path, walked forwards or backwards, or a quarter turn about one of its ends.
struct ContourElement {
  Point from;
  Point heading;  ///< unit vectors at both ends
  Point heading_to;
  Point centre;              ///< of an arc, or of the quarter turn
  double signed_radius = 0;  ///< positive: turns left; 0: quarter turn; unused by straight lines
  double turn = 0;           ///< left positive, rad
  double half_cosine = 1;    ///< of half the turn
  double start = 0;          ///< position where it begins
  double length = 0;         ///< m, or 1 for a quarter turn
  bool straight = false;
  bool cap = false;
};

/// A box round consecutive segments of the path; the entries after it up to `skip` lie within it.
struct ContourBox {
  Box box;
  std::size_t skip = 0;     ///< index of the next entry outside
  std::size_t element = 0;  ///< of a single segment
  bool single = false;
};

/// A position on it is the length walked from its beginning: m, and 1 for each quarter turn.
struct Contour {
  std::vector<ContourElement> elements;  ///< n on the right, 2 quarter turns, n on the left, 2 quarter turns
  std::size_t segments = 0;              ///< n
  double path_length = 0;                ///< m
  std::vector<ContourBox> boxes;         ///< halves, quarters … of the path, each before its parts

  double right_end() const { return path_length; }  ///< the right side is [0, right_end()]
  double left_start() const { return path_length + 2; }
  double left_end() const { return 2 * path_length + 2; }
  bool on_left(double position) const { return position > path_length + 1; }
};

/// Precondition: tangents are continuous; segments of positive length.
Contour contour_of(const Path& path);

/// The element on which the position lies; the earlier one of two that meet there. O(log n).
std::size_t element_at(const Contour& contour, double position);

/// Heading at a position of the element; unit vector.
Point heading_at(const ContourElement& element, double position);
/// The point `distance_m` to the right of a position of the element.
Point beside(const ContourElement& element, double position, double distance_m);

/// Whether an element has a parallel at that distance: on the inside of a bend it shrinks to the centre and
/// vanishes beyond.
inline bool has_parallel(const ContourElement& element, double distance_m) {
  return element.straight || element.signed_radius >= 0 ||
         element.signed_radius + distance_m < -kSameDistance_m;
}

/// Curvature of the parallel, left positive, 1/m. Precondition: has_parallel(), and not a quarter turn of
/// radius 0.
inline double curvature_beside(const ContourElement& element, double distance_m) {
  assert(has_parallel(element, distance_m));
  assert(!element.cap || distance_m != 0);
  return element.straight ? 0 : 1 / (element.signed_radius + distance_m);
}

/// The parallel of the contour between two positions. Precondition: every element in between has one at that
/// distance.
void append_parallel(const Contour& contour, double from, double to, double distance_m, Path& out);

/// Whether no point of the path lies nearer to p than the distance. `hint` is the element to look at first;
/// it becomes the one found to be nearer. Mostly O(log n): a box that is far enough away answers for all
/// elements in it.
bool keeps_away(const Contour& contour, Point p, double distance_m, std::size_t& hint);

}  // namespace tramline
