#include "tramline/tracks/projection.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

#include "tramline/tracks/tolerances.h"

namespace tramline {
namespace {

struct NearPoint {
  double at_m;
  double off_m;
};

}  // namespace

Projection::Projection(const Path& path) {
  assert(std::all_of(path.begin(), path.end(), [](const PathSegment& s) { return s.straight(); }));
  double at_m = 0;
  for (const PathSegment& segment : path) {
    const double length_m = length(segment);
    sides_.push_back({segment.from, (1 / length_m) * (segment.to - segment.from), length_m, at_m});
    at_m += length_m;
  }
}

std::vector<double> Projection::feet(Point p) const {
  std::vector<NearPoint> near;
  double least_m = std::numeric_limits<double>::infinity();
  bool beyond_last = true;  // the point lies beyond the end of the segment before
  const auto add = [&](const Side& side, double along_m) {
    const double off_m = length(p - side.from - along_m * side.along);
    least_m = std::min(least_m, off_m);
    near.push_back({side.at_m + along_m, off_m});
  };
  for (const Side& side : sides_) {
    const double along_m = dot(p - side.from, side.along);
    if (along_m > 0 && along_m < side.length_m)
      add(side, along_m);
    else if (along_m <= 0 && beyond_last)
      add(side, 0);
    beyond_last = along_m >= side.length_m;
  }
  if (beyond_last && !sides_.empty()) add(sides_.back(), sides_.back().length_m);
  std::vector<double> out;
  for (const NearPoint& foot : near)
    if (foot.off_m <= least_m + kEquidistant_m) out.push_back(foot.at_m);
  return out;
}

}  // namespace tramline
