#include "tramline/headland/path_stretch.h"

#include <cassert>
#include <cmath>

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

}  // namespace

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
