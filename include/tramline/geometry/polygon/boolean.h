#pragma once
// Polygon booleans and their relatives, on GEOS (re-entrant C API, one context per thread).
//
// Unions, intersections and differences are computed on a precision grid of kGridSize: GEOS 3.11's
// floating unary union can silently drop rectangles that touch within rounding error.
// All results are oriented (outer rings counter-clockwise) and free of empty parts.
// Every function throws Error(kFailure) when GEOS reports one.

#include <optional>
#include <string>
#include <vector>

#include "tramline/geometry/polygon/region.h"

namespace tramline {

Region unite(const Region& polygons);  ///< input polygons may overlap
Region unite(const Region& a,
             const Region& b);  ///< the parts of one region must not overlap; a single overlay
Region intersection(const Region& a, const Region& b);
Region difference(const Region& a, const Region& b);
Region symmetric_difference(const Region& a, const Region& b);

enum class JoinStyle { kRound, kMitre };
/// Points within `distance_m` of the region (negative: erosion). Round joins have
/// `segments_per_quadrant` chords; mitre joins are cut at twice the distance.
Region buffered(const Region& region, double distance_m, JoinStyle join = JoinStyle::kRound,
                int segments_per_quadrant = 8);
/// Flat-ended buffer of a polyline, mitre joins. Precondition: at least two distinct points.
Region buffered_line(const std::vector<Point>& line, double distance_m);
/// Points within `distance_m` of segment ab: a round-ended buffer.
Region line_neighbourhood(Point a, Point b, double distance_m);

/// Shortest distance between the two (0 where they meet), m.
double distance_between(const Region& a, const Region& b);
/// Shortest distance between a region and a ring taken as a line, m.
double distance_to_ring(const Region& region, const Ring& ring);

/// The largest disc within the polygon, its radius to within `tolerance_m`. Precondition: a valid polygon.
Disc largest_disc(const Polygon& polygon, double tolerance_m);

/// The smallest convex polygon that contains all points, at least a triangle. Empty where there are no three
/// points that are not collinear.
Region convex_hull(const std::vector<Point>& points);

/// Reason why a polygon is not a valid OGC polygon, and the point where; nullopt when it is valid.
struct Invalidity {
  std::string reason;
  Point place;
};
std::optional<Invalidity> find_invalidity(const Polygon& polygon);

/// The land enclosed an odd number of times by the rings of the polygon (GEOS make-valid, linework).
Region made_valid(const Polygon& polygon);

/// The polygon cut into triangles between its vertices (constrained Delaunay): they do not overlap, and their
/// union is the polygon. Precondition: a valid polygon.
Region triangles_of(const Polygon& polygon);

/// Faces of the arrangement of the polygon's rings and the polylines that lie inside it, on the
/// precision grid. They form a valid coverage: edges shared by two faces are identical.
Region split_by_lines(const Polygon& polygon, const std::vector<std::vector<Point>>& lines);

/// Length of the part of segment ab inside the region, m.
double length_inside(const Region& region, Point a, Point b);

}  // namespace tramline
