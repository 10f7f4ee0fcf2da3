#pragma once
// Angles as types: an Angle is an amount of turning, a Direction is axial (modulo 180 degrees, as of a
// track), a Heading is modulo 360 degrees (as of a machine). None can be made from a bare double.

#include <cmath>
#include <limits>
#include <numbers>

#include "tramline/geometry/point.h"

namespace tramline {

/// An amount of turning. Default constructed it is undefined (NaN).
class Angle {
 public:
  constexpr Angle() = default;
  static constexpr Angle radians(double value) { return Angle(value); }
  static constexpr Angle degrees(double value) { return Angle(value * std::numbers::pi / 180.0); }
  constexpr double radians() const { return radians_; }
  constexpr double degrees() const { return radians_ * 180.0 / std::numbers::pi; }

  friend constexpr Angle operator+(Angle a, Angle b) { return Angle(a.radians_ + b.radians_); }
  friend constexpr Angle operator-(Angle a, Angle b) { return Angle(a.radians_ - b.radians_); }
  friend constexpr Angle operator-(Angle a) { return Angle(-a.radians_); }
  // clang-tidy 14 takes the zero that results of <=> are compared with for a pointer.
  friend constexpr auto operator<=>(Angle a, Angle b) = default;  // NOLINT(modernize-use-nullptr)

 private:
  explicit constexpr Angle(double radians) : radians_(radians) {}
  double radians_ = std::numeric_limits<double>::quiet_NaN();
};

/// The axis along which tracks lie: clockwise from the frame's north (+y), in [0, 180) degrees.
/// Default constructed it is undefined (NaN).
class Direction {
 public:
  constexpr Direction() = default;
  /// Any angle clockwise from north; reduced modulo 180 degrees.
  static Direction clockwise_from_north(Angle angle);
  /// The axis through two points. Precondition: a != b.
  static Direction along(Point a, Point b);

  Angle angle() const { return Angle::radians(radians_); }
  double degrees() const { return angle().degrees(); }
  /// Unit vector along the axis, pointing to the half plane x > 0 (or to +y).
  Point unit() const { return {std::sin(radians_), std::cos(radians_)}; }
  Direction rotated(Angle clockwise) const { return clockwise_from_north(angle() + clockwise); }
  Direction perpendicular() const { return rotated(Angle::degrees(90)); }

  friend constexpr bool operator==(Direction a, Direction b) = default;
  friend constexpr bool operator<(Direction a, Direction b) { return a.radians_ < b.radians_; }

 private:
  explicit constexpr Direction(double radians) : radians_(radians) {}
  double radians_ = std::numeric_limits<double>::quiet_NaN();
};

/// Smallest angle between two axes, in [0, 90] degrees. Versleijen §2.2.3 compares axes: modulo 180 degrees.
Angle angle_between(Direction a, Direction b);

/// Where a machine points: clockwise from the frame's north, in [0, 360) degrees.
class Heading {
 public:
  constexpr Heading() = default;
  static Heading clockwise_from_north(Angle angle);
  /// Precondition: from != to.
  static Heading from_to(Point from, Point to);

  Angle angle() const { return Angle::radians(radians_); }
  double degrees() const { return angle().degrees(); }
  Point unit() const { return {std::sin(radians_), std::cos(radians_)}; }
  Direction direction() const { return Direction::clockwise_from_north(angle()); }

  friend constexpr bool operator==(Heading a, Heading b) = default;

 private:
  explicit constexpr Heading(double radians) : radians_(radians) {}
  double radians_ = std::numeric_limits<double>::quiet_NaN();
};

}  // namespace tramline
