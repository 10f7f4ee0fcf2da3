#include "tramline/geometry/path_between.h"

#include <algorithm>
#include <cassert>

#include "tramline/geometry/segment_frame.h"

namespace tramline {
namespace {

/// What is shorter is no part of a path, m.
constexpr double kShortestPart_m = 1e-9;

PathSegment part_of(const PathSegment& segment, double from, double to) {
  const double whole = length(segment);
  const SegmentFrame frame(segment, 0);
  const Point a = from <= 0 ? segment.from : frame.place(from, 0);
  const Point b = to >= whole ? segment.to : frame.place(to, 0);
  return {a, b, segment.curvature};
}

}  // namespace

Path path_between(const Path& path, double from, double to) {
  assert(from < to);
  assert(from >= -1e-3 && to <= length(path) + 1e-3);
  Path out;
  double start = 0;
  for (const PathSegment& segment : path) {
    const double whole = length(segment), low = std::max(0.0, from - start),
                 high = std::min(whole, to - start);
    start += whole;
    if (high - low <= kShortestPart_m) continue;
    PathSegment part = part_of(segment, low, high);
    if (!out.empty()) part.from = out.back().to;
    out.push_back(part);
  }
  return out;
}

}  // namespace tramline
