#include "tramline/geometry/path/measured_path.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <utility>

namespace tramline {

MeasuredPath::MeasuredPath(Path path) : path_(std::move(path)), starts_{0} {
  assert(std::all_of(path_.begin(), path_.end(), [](const PathSegment& s) { return s.from != s.to; }));
  for (const PathSegment& segment : path_) starts_.push_back(starts_.back() + tramline::length(segment));
}

PathPoint MeasuredPath::at(double along_m) const {
  along_m = std::clamp(along_m, 0.0, length());
  const auto after = std::upper_bound(starts_.begin() + 1, starts_.end() - 1, along_m);
  const auto i = static_cast<std::size_t>(after - starts_.begin()) - 1;
  const PathSegment& segment = path_[i];
  const Point first = direction_at_start(segment);
  const double on_m = along_m - starts_[i], angle = on_m * segment.curvature;
  if (segment.straight()) return {segment.from + on_m * first, first};
  const double chord_m = 2 * std::sin(0.5 * angle) / segment.curvature;
  return {segment.from + chord_m * turned(first, 0.5 * angle), turned(first, angle)};
}

}  // namespace tramline
