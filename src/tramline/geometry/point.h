#pragma once
// A point (or vector) of the plane: x east, y north, metres in the field's local frame.

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
inline double length(Point a) { return std::hypot(a.x, a.y); }
inline double distance(Point a, Point b) { return length(b - a); }
constexpr Point midpoint(Point a, Point b) { return {0.5 * (a.x + b.x), 0.5 * (a.y + b.y)}; }

}  // namespace tramline
