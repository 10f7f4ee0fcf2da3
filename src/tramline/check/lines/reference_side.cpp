#include "tramline/check/lines/reference_side.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <utility>

#include "tramline/check/measure/bands.h"
#include "tramline/check/measure/sound_path.h"
#include "tramline/check/tolerances.h"

namespace tramline::check {
namespace {

constexpr std::size_t kGroup = 8;

double distance_to(const Box& box, Point p) {
  return std::hypot(std::max({box.min_x - p.x, 0.0, p.x - box.max_x}),
                    std::max({box.min_y - p.y, 0.0, p.y - box.max_y}));
}

/// The distance along a segment of its nearest position to a point.
double along_of(const PathSegment& segment, Point p) {
  const double whole_m = length(segment);
  if (segment.straight())
    return std::clamp(dot(p - segment.from, segment.to - segment.from) / whole_m, 0.0, whole_m);
  const Point middle = centre(segment), first = segment.from - middle, there = p - middle;
  const double angle = std::atan2(cross(first, there), dot(first, there)) * segment.curvature;
  const double along_m = angle * radius(segment) * radius(segment);
  // Half a circle on, rounding may say that it is half a circle back.
  if (along_m < 0) return -along_m > 0.5 * whole_m ? whole_m : 0;
  return std::min(along_m, whole_m);
}

/// Whether an end of the line lies on a segment other than the one that leads to it.
bool end_touches(const Path& line) {
  for (std::size_t i = 0; i < line.size(); ++i) {
    const double first_m = i > 0 ? distance_to_edge(line[i], line.front().from, line.front().from) : 1;
    const bool last = i + 1 == line.size();
    const double last_m = last ? 1 : distance_to_edge(line[i], line.back().to, line.back().to);
    if (std::min(first_m, last_m) <= kLengthTolerance_m) return true;
  }
  return false;
}

}  // namespace

ReferenceSide::ReferenceSide(Path line) : line_(std::move(line)) {
  assert(fault_of(line_).empty());
  double from_m = 0;
  for (std::size_t i = 0; i < line_.size(); ++i) {
    starts_m_.push_back(from_m);
    from_m += length(line_[i]);
    boxes_.push_back(reach_of({line_[i]}, 0));
    if (i % kGroup == 0) groups_.push_back(boxes_.back());
    groups_.back().extend(boxes_.back());
  }
  starts_m_.push_back(from_m);
  round_ = distance(line_.front().from, line_.back().to) <= kLengthTolerance_m &&
           distance(direction_at_start(line_.front()), direction_at_end(line_.back())) <= kSameHeading;
  touches_itself_ = end_touches(line_);
}

template <class Look>
void ReferenceSide::each_near(Point p, double within_m, Look look) const {
  for (std::size_t g = 0; g < groups_.size(); ++g) {
    if (distance_to(groups_[g], p) >= within_m) continue;
    const std::size_t end = std::min(line_.size(), (g + 1) * kGroup);
    for (std::size_t i = g * kGroup; i < end; ++i)
      if (distance_to(boxes_[i], p) < within_m) within_m = look(i);
  }
}

Foot ReferenceSide::foot_of(Point p, double within_m) const {
  std::size_t nearest = line_.size();
  double off_m = within_m;
  each_near(p, within_m, [&](std::size_t i) {
    const double there_m = distance_to_edge(line_[i], p, p);
    if (there_m < off_m) {
      off_m = there_m;
      nearest = i;
    }
    return off_m;
  });
  Foot out;
  if (nearest == line_.size()) return out;
  const double on_segment_m = along_of(line_[nearest], p);
  const Point heading = heading_on(line_[nearest], on_segment_m);
  const Point across = p - check::point_on(line_[nearest], on_segment_m);
  out.along_m = starts_m_[nearest] + on_segment_m;
  out.off_m = off_m;
  out.on_right = cross(heading, across) < 0;
  const bool at_end = out.along_m <= kLengthTolerance_m || out.along_m >= length_m() - kLengthTolerance_m;
  out.square = !at_end || std::abs(dot(heading, across)) <= 2 * kLengthTolerance_m;
  return out;
}

bool ReferenceSide::keeps_off(Point p, double distance_m) const {
  bool keeps = true;
  const double least_m = distance_m - kDistanceRounding_m;
  each_near(p, least_m, [&](std::size_t i) {
    keeps = keeps && distance_to_edge(line_[i], p, p) >= least_m;
    return keeps ? least_m : -1;  // nothing is nearer than that
  });
  return keeps;
}

std::size_t ReferenceSide::segment_at(double along_m) const {
  const auto next = std::upper_bound(starts_m_.begin(), starts_m_.end() - 1, along_m);
  return next == starts_m_.begin() ? 0 : static_cast<std::size_t>(next - starts_m_.begin()) - 1;
}

Point ReferenceSide::heading_at(double along_m) const {
  const std::size_t i = segment_at(along_m);
  return heading_on(line_[i], along_m - starts_m_[i]);
}

Point ReferenceSide::beside(double along_m, double off_m) const {
  const std::size_t i = segment_at(along_m);
  const double on_segment_m = along_m - starts_m_[i];
  return check::point_on(line_[i], on_segment_m) + off_m * right_of(heading_on(line_[i], on_segment_m));
}

double ReferenceSide::curvature_at(double along_m) const { return line_[segment_at(along_m)].curvature; }

void ReferenceSide::append_beside(double from_m, double to_m, double off_m, Path& out) const {
  for (std::size_t i = segment_at(from_m); i < line_.size() && starts_m_[i] < to_m; ++i) {
    const PathSegment& segment = line_[i];
    const double first_m = std::max(0.0, from_m - starts_m_[i]);
    const double last_m = std::min(to_m, starts_m_[i + 1]) - starts_m_[i];
    const Point from = check::point_on(segment, first_m) + off_m * right_of(heading_on(segment, first_m));
    const Point to = check::point_on(segment, last_m) + off_m * right_of(heading_on(segment, last_m));
    if (distance(from, to) <= kJoint_m) continue;
    out.push_back({from, to, segment.straight() ? 0 : 1 / (1 / segment.curvature + off_m)});
  }
}

}  // namespace tramline::check
