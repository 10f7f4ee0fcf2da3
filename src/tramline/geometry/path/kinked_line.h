#pragma once
// Polylines that keep their kinks, with the operators of Zhou §2.2 on them: no machine drives them, but
// tracks are such lines in the papers.

#include <vector>

#include "tramline/geometry/path/path.h"

namespace tramline {

/// Straight segments through the points. Precondition: no two consecutive points coincide.
Path polyline_path(const std::vector<Point>& points);
/// The inverse. Precondition: all segments straight.
std::vector<Point> vertices_of(const Path& path);

/// Whether a path has straight segments only, two of which meet at an angle of more than kLeastKink_rad, by
/// which the shorter one leads aside by more than kShortest_m.
bool has_kinks(const Path& path);

/// The area of a swath along a path of straight segments (Π of Zhou §2.2), a convex quadrilateral for each,
/// counter-clockwise. Where segments meet, both sides are lengthened or cut to the bisector of the kink: the
/// swath gains outside it what it loses inside, so each quadrilateral has the area width · length, and those
/// of a swath only touch. Kinks sharper than 120° and those beside a segment too short for that have flat
/// ends on both segments instead, which leave a wedge outside and overlap inside. O(n).
std::vector<Ring> kinked_cells(const Path& path, double width_m);

/// The outline of that area: its two sides and flat ends, which crosses itself where flat ends meet.
Ring kinked_band(const Path& path, double width_m);

}  // namespace tramline
