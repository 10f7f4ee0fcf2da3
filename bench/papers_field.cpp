#include "papers_field.h"

#include <cmath>
#include <numbers>

namespace tramline::bench {
namespace {

Obstacle square_obstacle(Point corner, double side, double turn) {
  const Point along{side * std::cos(turn), side * std::sin(turn)}, up{-along.y, along.x};
  return {
      {{corner, corner + along, corner + along + up, corner + up}, {}}, ObstacleKind::kObstacle, "obstacle"};
}

/// An outline that waves round an ellipse, so that it has reflex corners.
Ring waving_outline(int corners, double half_width, double half_height, int waves) {
  Ring ring;
  for (int i = 0; i < corners; ++i) {
    const double angle = 2 * std::numbers::pi * i / corners;
    const double swell = 1 + 0.08 * std::sin(waves * angle + 0.4) + 0.01 * std::sin(0.37 * i);
    ring.push_back({half_width * swell * std::cos(angle), half_height * swell * std::sin(angle)});
  }
  return ring;
}

}  // namespace

Field papers_field() {
  Field field;
  field.id = "papers";
  field.outer = waving_outline(65, 220, 115, 5);
  field.obstacles = {square_obstacle({-60, 10}, 7, 0.13), square_obstacle({75, -20}, 7, 0.61)};
  return field;
}

Field large_field(int vertices, int obstacles) {
  Field field;
  field.id = "large";
  field.outer = waving_outline(vertices, 600, 330, 9);
  for (int i = 0; i < obstacles; ++i)
    field.obstacles.push_back(square_obstacle({-420.0 + 44 * i, 60 * std::sin(1.7 * i)}, 9, 0.21 * i));
  return field;
}

}  // namespace tramline::bench
