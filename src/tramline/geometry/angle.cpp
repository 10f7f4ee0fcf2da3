#include "tramline/geometry/angle.h"

#include <algorithm>
#include <cassert>

namespace tramline {
namespace {

/// value modulo period, in [0, period), also where rounding would give the period itself.
double reduce(double value, double period) {
  double reduced = std::fmod(value, period);
  if (reduced < 0) reduced += period;
  return reduced >= period ? 0.0 : reduced;
}

}  // namespace

Direction Direction::clockwise_from_north(Angle angle) {
  return Direction(reduce(angle.radians(), std::numbers::pi));
}

Direction Direction::along(Point a, Point b) {
  assert(a != b);
  return clockwise_from_north(Angle::radians(std::atan2(b.x - a.x, b.y - a.y)));
}

Angle angle_between(Direction a, Direction b) {
  const double difference = std::abs(a.angle().radians() - b.angle().radians());
  return Angle::radians(std::min(difference, std::numbers::pi - difference));
}

Heading Heading::clockwise_from_north(Angle angle) {
  return Heading(reduce(angle.radians(), 2 * std::numbers::pi));
}

Heading Heading::from_to(Point from, Point to) {
  assert(from != to);
  return clockwise_from_north(Angle::radians(std::atan2(to.x - from.x, to.y - from.y)));
}

}  // namespace tramline
