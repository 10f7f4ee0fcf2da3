#pragma once
// A pose in the frame of another.

#include <cmath>
#include <numbers>

#include "tramline/geometry/path/steered_path.h"

namespace tramline {

inline constexpr double kWholeCircle = 2 * std::numbers::pi;

/// An angle modulo a whole circle, in [0, 2π), for angles of no more than a few circles.
inline double in_whole_circle(double angle) {
  while (angle < 0) angle += kWholeCircle;
  while (angle >= kWholeCircle) angle -= kWholeCircle;
  return angle;
}
/// The same in [−π, π).
inline double in_half_circles(double angle) {
  return in_whole_circle(angle + std::numbers::pi) - std::numbers::pi;
}

/// Where a pose is from another one: metres ahead and to the left, and the anticlockwise angle between the
/// headings in [0, 2π), with its sine and cosine.
struct RelativePose {
  double ahead = 0;
  double left = 0;
  double turn = 0;
  double sine = 0;
  double cosine = 1;

  /// Mirrored in the axis ahead.
  RelativePose mirrored() const { return {ahead, -left, in_whole_circle(-turn), -sine, cosine}; }
};

/// `unit`, `other`: where the poses head for.
inline RelativePose relative(const Pose& from, Point unit, const Pose& to, Point other) {
  const Point way = to.at - from.at;
  return {dot(way, unit), cross(unit, way),
          in_whole_circle(from.heading.angle().radians() - to.heading.angle().radians()), cross(unit, other),
          dot(unit, other)};
}

inline RelativePose relative(const Pose& from, const Pose& to) {
  return relative(from, from.heading.unit(), to, to.heading.unit());
}

}  // namespace tramline
