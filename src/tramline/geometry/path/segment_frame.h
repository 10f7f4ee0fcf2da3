#pragma once
// The coordinates of one segment.

#include <algorithm>
#include <cmath>

#include "tramline/geometry/path/path.h"

namespace tramline {

/// The frame of a segment: metres to the right and along, or, for arcs, Cartesian coordinates about the
/// centre whose first axis points to the arc's middle and in which the path turns left.
class SegmentFrame {
 public:
  SegmentFrame(const PathSegment& segment, double half_width) : half_(half_width) {
    // Square roots instead of the angles of path.h: this is computed for every segment of every track.
    const Point chord = segment.to - segment.from;
    const double across = tramline::length(chord);
    origin_ = segment.from;
    ahead_ = (1 / across) * chord;
    length_ = across;
    if (segment.straight()) return;
    radius_ = 1 / std::abs(segment.curvature);
    sense_ = segment.curvature > 0 ? 1 : -1;
    const double sine = std::min(1.0, 0.5 * across / radius_);
    half_turn_ = std::asin(sine);
    length_ = 2 * half_turn_ * radius_;
    ahead_ = -sense_ * to_the_left(ahead_);
    origin_ = midpoint(segment.from, segment.to) - (radius_ * std::sqrt((1 - sine) * (1 + sine))) * ahead_;
  }

  bool straight() const { return radius_ == 0; }
  double radius() const { return radius_; }
  int sense() const { return sense_; }
  double half_turn() const { return half_turn_; }
  double length() const { return length_; }

  Point local(Point p) const {
    const Point d = p - origin_;
    if (straight()) return {cross(d, ahead_), dot(d, ahead_)};
    return {dot(d, ahead_), sense_ * cross(ahead_, d)};
  }

  /// Distance from the left end of the cross-section, and position along, of a local point.
  double across(Point q) const {
    return straight() ? q.x + half_ : sense_ * (std::sqrt(dot(q, q)) - radius_) + half_;
  }
  double along(Point q) const { return straight() ? q.y : radius_ * (std::atan2(q.y, q.x) + half_turn_); }

  /// The point of the field at a position along and a distance from the left end.
  Point point_at(double along, double across) const {
    if (straight()) return origin_ + along * ahead_ - (across - half_) * to_the_left(ahead_);
    const double angle = sense_ * (along / radius_ - half_turn_);
    const double c = std::cos(angle), s = std::sin(angle);
    return origin_ + (radius_ + sense_ * (across - half_)) *
                         Point{c * ahead_.x - s * ahead_.y, s * ahead_.x + c * ahead_.y};
  }

 private:
  static Point to_the_left(Point direction) { return {-direction.y, direction.x}; }

  double half_;
  Point origin_;
  Point ahead_;
  double length_ = 0;
  double radius_ = 0;
  int sense_ = 0;
  double half_turn_ = 0;
};

}  // namespace tramline
