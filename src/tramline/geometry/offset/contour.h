#pragma once
// The way round a path: along its right side, about its end, back along its left side, about its start.
// Whoever walks it has the path to the left and sees the plane to the right: one side to work on instead
// of two, and the fronts of both sides may meet.

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
  Point centre;      ///< of an arc, or of the quarter turn
  double reach = 0;  ///< signed radius, positive: turns left; 0: quarter turn; not used by straight lines
  double turn = 0;   ///< left positive, rad
  double half_cosine = 1;  ///< of half the turn
  double start = 0;        ///< the place where it begins
  double length = 0;       ///< in places: m, or 1 for a quarter turn
  bool straight = false;
  bool cap = false;
};

/// A box round some of the path's segments in a row; those after it up to `skip` lie within it.
struct ContourBox {
  Box box;
  std::size_t skip = 0;     ///< the next one that does not
  std::size_t element = 0;  ///< of a single segment
  bool single = false;
};

/// A place on it is told by how far one has walked: m, and 1 for each quarter turn.
struct Contour {
  std::vector<ContourElement> elements;  ///< n on the right, 2 quarter turns, n on the left, 2 quarter turns
  std::size_t segments = 0;              ///< n
  double path_length = 0;                ///< m
  std::vector<ContourBox> boxes;         ///< halves, quarters … of the path, each before its parts

  double right_end() const { return path_length; }  ///< the right side is [0, right_end()]
  double left_start() const { return path_length + 2; }
  double left_end() const { return 2 * path_length + 2; }
  bool on_left(double place) const { return place > path_length + 1; }
};

/// Precondition: tangents are continuous; segments of positive length.
Contour contour_of(const Path& path);

/// The element on which the place lies; of two that meet there the earlier one. O(log n).
std::size_t element_at(const Contour& contour, double place);

/// Heading at a place of the element; unit vector.
Point heading_at(const ContourElement& element, double place);
/// The point `distance_m` to the right of a place of the element.
Point beside(const ContourElement& element, double place, double distance_m);

/// Whether an element still has a parallel at that distance: on the inside of a bend it shrinks to
/// the centre and is gone beyond.
inline bool reaches(const ContourElement& element, double distance_m) {
  return element.straight || element.reach >= 0 || element.reach + distance_m < -kSameDistance_m;
}

/// Curvature of the parallel, left positive, 1/m. Precondition: reaches(), and not a quarter turn of radius
/// 0.
inline double curvature_beside(const ContourElement& element, double distance_m) {
  assert(reaches(element, distance_m));
  assert(!element.cap || distance_m != 0);
  return element.straight ? 0 : 1 / (element.reach + distance_m);
}

/// The parallel of what lies between two places. Precondition: every element in between reaches that far.
void append_parallel(const Contour& contour, double from, double to, double distance_m, Path& out);

/// No point of the path lies nearer to p than the distance. `hint` is an element to look at first; it
/// becomes the one that is nearer. Mostly O(log n): boxes that are far enough away answer for all in them.
bool keeps_away(const Contour& contour, Point p, double distance_m, std::size_t& hint);

}  // namespace tramline
