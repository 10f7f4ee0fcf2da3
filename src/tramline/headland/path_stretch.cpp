#include "tramline/headland/path_stretch.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

#include "tramline/headland/tolerances.h"

namespace tramline {
namespace {

Point point_on(const PathSegment& segment, double along_m, double length_m) {
  const double share = along_m / length_m;
  if (segment.straight()) return segment.from + share * (segment.to - segment.from);
  const Point middle = centre(segment), spoke = segment.from - middle;
  const double angle = share * turning(segment), c = std::cos(angle), s = std::sin(angle);
  return middle + Point{c * spoke.x - s * spoke.y, s * spoke.x + c * spoke.y};
}

/// Appends the part of a segment between two positions along it.
void append(const PathSegment& segment, double from_m, double to_m, double length_m, Path& out) {
  if (from_m < kSamePlace_m) from_m = 0;
  if (to_m > length_m - kSamePlace_m) to_m = length_m;
  if (to_m - from_m < kSamePlace_m) return;
  const Point from = from_m > 0 ? point_on(segment, from_m, length_m) : segment.from;
  const Point to = to_m < length_m ? point_on(segment, to_m, length_m) : segment.to;
  out.push_back({out.empty() ? from : out.back().to, to, segment.curvature});
}

/// Where along a segment it is nearest to a point, m.
double nearest_on_m(const PathSegment& segment, Point to, double length_m) {
  if (segment.straight())
    return std::clamp(dot(to - segment.from, direction_at_start(segment)), 0.0, length_m);
  const Point spoke = segment.from - centre(segment), towards = to - centre(segment);
  const double angle = std::atan2(cross(spoke, towards), dot(spoke, towards));
  const double ahead = segment.curvature > 0 ? angle : -angle;
  if (ahead >= 0 && ahead <= std::abs(turning(segment))) return ahead * radius(segment);
  return distance(to, segment.from) < distance(to, segment.to) ? 0 : length_m;
}

}  // namespace

double nearest_along_m(const Path& path, Point to) {
  double at_m = 0, out = 0, nearest_m = std::numeric_limits<double>::infinity();
  for (const PathSegment& segment : path) {
    const double length_m = length(segment), on_m = nearest_on_m(segment, to, length_m);
    const double distance_m = distance(to, point_on(segment, on_m, length_m));
    if (distance_m < nearest_m) {
      nearest_m = distance_m;
      out = at_m + on_m;
    }
    at_m += length_m;
  }
  return out;
}

Path stretch_of(const Path& path, double from_m, double to_m) {
  assert(0 <= from_m && from_m < to_m);
  Path out;
  double at_m = 0;
  for (int round = 0; round < 2 && at_m < to_m; ++round)
    for (const PathSegment& segment : path) {
      const double length_m = length(segment);
      if (from_m < at_m + length_m && to_m > at_m)
        append(segment, std::max(0.0, from_m - at_m), std::min(length_m, to_m - at_m), length_m, out);
      at_m += length_m;
    }
  return out;
}

}  // namespace tramline
