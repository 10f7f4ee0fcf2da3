#include "tramline/turns/turn_off.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "tramline/turns/outline/outline.h"
#include "tramline/turns/track_ends.h"

namespace tramline {
namespace {

constexpr double kQuarter_rad = std::numbers::pi / 2;

/// A quarter turn. While the machine steers at its full rate the curvature grows evenly with the way; where a
/// quarter turn ends before the smallest circle is reached it steers back at once.
void append_quarter_turn(const Machine& machine, double sense, SteeredPath& path) {
  const Turning& turning = machine.turning;
  double curvature = 1 / std::max(machine.radius_m, kLeastRadius_m);
  double steering_m = turning.turning_speed_mps * turning.steering_time_s;
  if (steering_m * curvature > kQuarter_rad) {
    const double share = std::sqrt(kQuarter_rad / (steering_m * curvature));
    curvature *= share;
    steering_m *= share;
  }
  const double arc_m = std::max(0.0, kQuarter_rad / curvature - steering_m);
  const auto append = [&](double length_m, double from, double to) {
    if (length_m > 0) path.push_back({end_of(path.back()), length_m, sense * from, sense * to});
  };
  append(steering_m, 0, curvature);
  append(arc_m, curvature, curvature);
  append(steering_m, curvature, 0);
}

}  // namespace

std::array<SteeredPath, 2> ways_off(const Pose& axle_at_end, const Machine& machine) {
  const SteeredStretch on{axle_at_end, machine.turning.lift_m};
  std::array<SteeredPath, 2> out{SteeredPath{on}, SteeredPath{on}};
  append_quarter_turn(machine, +1, out[0]);
  append_quarter_turn(machine, -1, out[1]);
  return out;
}

std::array<SteeredPath, 2> ways_off_end(Point end, Heading heading, const Machine& machine) {
  return ways_off({end + reach_back_m(machine.turning) * heading.unit(), heading}, machine);
}

bool has_way_off(const AllowedLand& land, Point end, Heading heading, const Machine& machine) {
  const Outline outline = outline_of(machine);
  for (const SteeredPath& way : ways_off_end(end, heading, machine))
    if (land.fits(way, outline)) return true;
  return false;
}

}  // namespace tramline
