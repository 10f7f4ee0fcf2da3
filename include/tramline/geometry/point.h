#pragma once
// A point (or vector) of the plane: x east, y north, metres in the field's local frame.

#include <algorithm>
#include <cmath>

namespace tramline {

struct Point {
  double x = 0;
  double y = 0;

  friend constexpr bool operator==(Point a, Point b) = default;
  friend constexpr Point operator+(Point a, Point b) { return {a.x + b.x, a.y + b.y}; }
  friend constexpr Point operator-(Point a, Point b) { return {a.x - b.x, a.y - b.y}; }
  friend constexpr Point operator*(double k, Point p) { return {k * p.x, k * p.y}; }
};

constexpr double dot(Point a, Point b) { return a.x * b.x + a.y * b.y; }
/// Positive where b lies counter-clockwise of a.
constexpr double cross(Point a, Point b) { return a.x * b.y - a.y * b.x; }
/// A square root: no field is so large or so small that a square would leave the range of numbers, and a
/// hypotenuse takes several times as long.
inline double length(Point a) { return std::sqrt(dot(a, a)); }
inline double distance(Point a, Point b) { return length(b - a); }
constexpr Point midpoint(Point a, Point b) { return {0.5 * (a.x + b.x), 0.5 * (a.y + b.y)}; }
constexpr Point left_of(Point direction) { return {-direction.y, direction.x}; }
constexpr Point right_of(Point direction) { return {direction.y, -direction.x}; }
/// The vector turned anticlockwise.
inline Point turned(Point direction, double angle_rad) {
  const double c = std::cos(angle_rad), s = std::sin(angle_rad);
  return {c * direction.x - s * direction.y, s * direction.x + c * direction.y};
}
/// Distance from a point to the segment from a to b, which may have no length.
inline double distance_to_segment(Point p, Point a, Point b) {
  const Point along = b - a;
  const double square = dot(along, along);
  const double share = square > 0 ? std::clamp(dot(p - a, along) / square, 0.0, 1.0) : 0;
  return distance(p, a + share * along);
}

}  // namespace tramline
