#include "tramline/check/turning/axle_line.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "tramline/check/turning/driven_machine.h"

namespace tramline::check {
namespace {

LinePlace along(const PathSegment& segment, double by_m) {
  const Point start = direction_at_start(segment);
  if (segment.straight()) return {segment.from + by_m * start, start};
  const Point middle = centre(segment);
  const double angle = by_m * segment.curvature;
  return {middle + turned(segment.from - middle, angle), turned(start, angle)};
}

/// How far along the segment its nearest point is.
double nearest_m(const PathSegment& segment, Point p) {
  const double whole_m = length(segment);
  const Point start = direction_at_start(segment);
  if (segment.straight()) return std::clamp(dot(p - segment.from, start), 0.0, whole_m);
  const Point middle = centre(segment), spoke = segment.from - middle, to = p - middle;
  const double sense = segment.curvature > 0 ? 1 : -1;
  const double angle = sense * std::atan2(cross(spoke, to), dot(spoke, to));
  const double at_m = angle * radius(segment);
  if (at_m >= 0 && at_m <= whole_m) return at_m;
  return distance(p, segment.from) < distance(p, segment.to) ? 0 : whole_m;
}

}  // namespace

double ahead_of_work_m(const Machine& machine) {
  const Turning& turning = machine.turning;
  return turning.implement_offset_m + (turning.implement == Coupling::kTowed ? turning.drawbar_m : 0);
}

AxleLine::AxleLine(const Path& path, PathEnds ends) : ends_(ends) {
  for (const PathSegment& segment : path) {
    if (segment.from == segment.to) continue;
    path_.push_back(segment);
    begins_m_.push_back(length_m_);
    length_m_ += length(segment);
  }
  assert(!path_.empty());
}

LinePlace AxleLine::place(double at_m) const {
  if (ends_ == PathEnds::kMeet) {
    at_m = std::fmod(at_m, length_m_);
    if (at_m < 0) at_m += length_m_;
  }
  if (at_m <= 0) {
    const Point ahead = direction_at_start(path_.front());
    return {path_.front().from + at_m * ahead, ahead};
  }
  if (at_m >= length_m_) {
    const Point ahead = direction_at_end(path_.back());
    return {path_.back().to + (at_m - length_m_) * ahead, ahead};
  }
  const auto next = std::upper_bound(begins_m_.begin(), begins_m_.end(), at_m);
  const auto i = static_cast<std::size_t>(next - begins_m_.begin()) - 1;
  return along(path_[i], at_m - begins_m_[i]);
}

std::vector<double> AxleLine::positions_near(Point p, double within_m) const {
  std::vector<double> out;
  for (std::size_t i = 0; i < path_.size(); ++i) {
    const double at_m = nearest_m(path_[i], p);
    if (distance(along(path_[i], at_m).at, p) <= within_m) out.push_back(begins_m_[i] + at_m);
  }
  return out;
}

std::vector<CoursePlace> course_of(const SteeredPath& path, double step_m) {
  static const Machine kAxleAlone{};
  std::vector<CoursePlace> out;
  double begins_m = 0;
  for (const SteeredStretch& stretch : path) {
    const std::vector<MachinePlace> places = places_along({stretch}, kAxleAlone, step_m);
    const double each_m = places.size() > 1 ? stretch.length_m / static_cast<double>(places.size() - 1) : 0;
    for (std::size_t i = 0; i < places.size(); ++i)
      out.push_back({begins_m + static_cast<double>(i) * each_m, {places[i].axle, places[i].ahead}});
    begins_m += stretch.length_m;
  }
  return out;
}

LinePlace last_place(const SteeredPath& path) {
  static const Machine kAxleAlone{};
  constexpr double kStep_m = 1;
  const MachinePlace last = places_along({path.back()}, kAxleAlone, kStep_m).back();
  return {last.axle, last.ahead};
}

LinePlace first_place(const SteeredPath& path) {
  return {path.front().start.at, path.front().start.heading.unit()};
}

}  // namespace tramline::check
