#include "tramline/turns/manoeuvres/turn_curve.h"

#include <cassert>
#include <cmath>
#include <limits>

#include "tramline/turns/tolerances.h"

namespace tramline {
namespace {

struct ClothoidEnd {
  double ahead = 0, left = 0;
};

/// End of a clothoid to the left from straight ahead.
ClothoidEnd clothoid_from_straight(double length_m, double curvature) {
  const Pose end = end_of(
      {{{0, 0}, Heading::clockwise_from_north(Angle::radians(0))}, length_m, 0, curvature, Gear::kForward});
  return {end.at.y, -end.at.x};
}

SteeredPath clothoids_and_arc(const Pose& from, double clothoid_m, double arc_m, double curvature,
                              Gear gear) {
  SteeredPath path;
  path.push_back({from, clothoid_m, 0, curvature, gear});
  if (arc_m > 0) path.push_back(arc_from(end_of(path.back()), arc_m, curvature, gear));
  path.push_back({end_of(path.back()), clothoid_m, curvature, 0, gear});
  return path;
}

/// The length of each clothoid of the elementary path: both deflect by half, and together they span the chord
/// between the two poses on the circle. A clothoid of length 1 spans a share of it, and all are similar.
double elementary_clothoid(double deflection_rad, const TurnCurve& curve) {
  const double half = 0.5 * deflection_rad;
  const ClothoidEnd unit = clothoid_from_straight(1, deflection_rad);
  const double chord = curve.ahead_m * std::cos(half) + curve.aside_m * std::sin(half);
  return chord / (unit.ahead * std::cos(half) + unit.left * std::sin(half));
}

}  // namespace

TurnCurve turn_curve(double radius_m, double sharpness) {
  assert(radius_m > 0 && sharpness > 0);
  if (std::isinf(sharpness)) return arc_turn(radius_m);
  TurnCurve curve{radius_m, sharpness, 1 / (radius_m * sharpness)};
  const ClothoidEnd end = clothoid_from_straight(curve.clothoid_m, 1 / radius_m);
  const double angle = 0.5 * curve.clothoid_m / radius_m;
  curve.ahead_m = end.ahead - radius_m * std::sin(angle);
  curve.aside_m = end.left + radius_m * std::cos(angle);
  curve.full_deflection_rad = curve.clothoid_m / radius_m;
  return curve;
}

TurnCurve arc_turn(double radius_m) {
  assert(radius_m > 0);
  return {radius_m, std::numeric_limits<double>::infinity(), 0, 0, radius_m, 0};
}

TurnCurves turn_curves(const Machine& machine) {
  const Turning& turning = machine.turning;
  if (!(turning.steering_time_s > 0)) return arc_turns(machine.radius_m);
  const auto at = [&](double speed_mps) {
    return turn_curve(machine.radius_m, 1 / (machine.radius_m * turning.steering_time_s * speed_mps));
  };
  return {at(turning.turning_speed_mps), at(turning.reverse_speed_mps)};
}

TurnCurves arc_turns(double radius_m) { return {arc_turn(radius_m), arc_turn(radius_m)}; }

std::optional<SteeredPath> turn_from(const Pose& from, double deflection_rad, TurnSide side, Gear gear,
                                     const TurnCurve& curve) {
  assert(deflection_rad > 0);
  const double sign = side == TurnSide::kLeft ? 1 : -1;
  if (curve.at_once())
    return SteeredPath{arc_from(from, deflection_rad * curve.radius_m, sign / curve.radius_m, gear)};
  const double beyond = deflection_rad - curve.full_deflection_rad;
  if (beyond >= 0)
    return clothoids_and_arc(from, curve.clothoid_m, beyond * curve.radius_m, sign / curve.radius_m, gear);
  const double clothoid_m = elementary_clothoid(deflection_rad, curve);
  const double curvature = deflection_rad / clothoid_m;
  if (!(clothoid_m > 0) || curvature / clothoid_m > (1 + kSharper) * curve.sharpness) return {};
  return clothoids_and_arc(from, clothoid_m, 0, sign * curvature, gear);
}

}  // namespace tramline
