#pragma once
// Rings, polygons with holes and regions, as plain values.

#include <algorithm>
#include <limits>
#include <vector>

#include "tramline/geometry/point.h"

namespace tramline {

/// A closed ring without the repeated last point: the edge from back() to front() is implied.
using Ring = std::vector<Point>;

/// An outer ring (counter-clockwise) with holes (clockwise), all simple. Holes lie inside.
struct Polygon {
  Ring outer;
  std::vector<Ring> holes;

  friend bool operator==(const Polygon& a, const Polygon& b) = default;
};

/// Polygons with disjoint interiors.
using Region = std::vector<Polygon>;

struct Disc {
  Point centre;
  double radius_m = 0;
};

/// An axis-parallel box. Default constructed it is empty.
struct Box {
  double min_x = std::numeric_limits<double>::infinity();
  double min_y = std::numeric_limits<double>::infinity();
  double max_x = -std::numeric_limits<double>::infinity();
  double max_y = -std::numeric_limits<double>::infinity();

  bool empty() const { return min_x > max_x; }
  double width() const { return max_x - min_x; }
  double height() const { return max_y - min_y; }
  Point centre() const { return {0.5 * (min_x + max_x), 0.5 * (min_y + max_y)}; }
  void extend(Point p);
  void extend(const Box& other);
  Box grown(double margin) const { return {min_x - margin, min_y - margin, max_x + margin, max_y + margin}; }
};
bool intersects(const Box& a, const Box& b);

/// Bounding box of the edge between two points.
inline Box bounds(Point a, Point b) {
  return {std::min(a.x, b.x), std::min(a.y, b.y), std::max(a.x, b.x), std::max(a.y, b.y)};
}
Box bounds(const Ring& ring);
Box bounds(const Polygon& polygon);
Box bounds(const Region& region);

/// Positive for counter-clockwise rings; m². Computed about the first vertex, so that rings far
/// from the origin keep their digits.
double signed_area(const Ring& ring);
/// Area of the outer ring less the holes, whatever their winding; m².
double area(const Polygon& polygon);
double area(const Region& region);

double perimeter(const Ring& ring);
Ring reversed(Ring ring);
/// The same polygon with the outer ring counter-clockwise and the holes clockwise.
Polygon oriented(Polygon polygon);
/// All rings of a region, outer rings first within each polygon.
std::vector<Ring> rings_of(const Region& region);

/// Even-odd test; points on the boundary may go either way. O(n).
bool contains(const Ring& ring, Point p);
bool contains(const Polygon& polygon, Point p);
bool contains(const Region& region, Point p);

/// Number of vertices over all rings.
std::size_t vertex_count(const Region& region);

}  // namespace tramline
