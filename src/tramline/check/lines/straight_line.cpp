#include "tramline/check/lines/straight_line.h"

#include <cassert>
#include <cmath>

#include "tramline/check/tolerances.h"

namespace tramline::check {

StraightLine::StraightLine(Point through, Point heading) : through_(through), heading_(heading) {
  assert(std::abs(length(heading) - 1) < kShortest_m);
}

TrackPosition StraightLine::foot_of(Point p) const {
  const double along_m = dot(p - through_, heading_);
  return {through_ + along_m * heading_, heading_, along_m, 0, false};
}

std::optional<TrackPosition> StraightLine::position_of(Point p) const {
  // Written so that NaN lies off the line.
  if (!(std::abs(cross(heading_, p - through_)) <= kLengthTolerance_m)) return std::nullopt;
  return foot_of(p);
}

Walk StraightLine::walk(const TrackPosition& from, const TrackPosition& to) const {
  if (before(to, from)) return {};
  Walk out{{}, WalkEnd::kReached};
  if (to.along_m - from.along_m > kShortest_m) out.path = straight_path(from.at, to.at);
  return out;
}

}  // namespace tramline::check
