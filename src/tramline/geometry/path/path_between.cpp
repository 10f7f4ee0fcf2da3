#include "tramline/geometry/path/path_between.h"

#include <algorithm>
#include <cassert>

#include "tramline/geometry/path/segment_frame.h"
#include "tramline/geometry/tolerances.h"

namespace tramline {
namespace {

PathSegment part_of(const PathSegment& segment, double from, double to) {
  const double whole = length(segment);
  const SegmentFrame frame(segment, 0);
  const Point a = from <= 0 ? segment.from : frame.point_at(from, 0);
  const Point b = to >= whole ? segment.to : frame.point_at(to, 0);
  return {a, b, segment.curvature};
}

}  // namespace

Path path_between(const Path& path, double from, double to) {
  assert(from < to);
  assert(from >= -kBeyondEnd_m && to <= length(path) + kBeyondEnd_m);
  Path out;
  double start = 0;
  for (const PathSegment& segment : path) {
    const double whole = length(segment), low = std::max(0.0, from - start),
                 high = std::min(whole, to - start);
    start += whole;
    if (high - low <= kShortest_m) continue;
    PathSegment part = part_of(segment, low, high);
    if (!out.empty()) part.from = out.back().to;
    out.push_back(part);
  }
  return out;
}

}  // namespace tramline
