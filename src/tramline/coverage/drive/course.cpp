#include "tramline/coverage/drive/course.h"

#include <algorithm>

namespace tramline::coverage {
namespace {

/// Places kept: enough for kCourseBase_m at kLeastStep_m, in a circle too.
constexpr std::size_t kTrail = 32;

Heading opposite(Heading heading) {
  return Heading::clockwise_from_north(heading.angle() + Angle::degrees(180));
}

}  // namespace

bool reverses(Heading heading, Heading course) {
  return dot(heading.unit(), course.unit()) < std::cos(kReversing.radians());
}

std::optional<Heading> Course::at(Point position) {
  if (trail_.empty()) trail_.push_back(position);
  if (distance(trail_.back(), position) < kLeastStep_m) return heading_;
  const auto base = std::find_if(trail_.rbegin(), trail_.rend(),
                                 [&](Point p) { return distance(p, position) >= kCourseBase_m; });
  if (base != trail_.rend()) {
    const Heading course = Heading::from_to(*base, position);
    heading_ = heading_ && reverses(*heading_, course) ? opposite(course) : course;
  }
  trail_.push_back(position);
  // The oldest place stays: while the machine stands it is all there is to tell where it came from.
  if (trail_.size() > kTrail) trail_.erase(trail_.begin() + (base == trail_.rend() ? 1 : 0));
  return heading_;
}

void Course::forget() {
  trail_.clear();
  heading_.reset();
}

}  // namespace tramline::coverage
