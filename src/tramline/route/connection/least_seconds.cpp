#include "tramline/route/connection/least_seconds.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "tramline/route/axle/axle_path.h"
#include "tramline/turns/manoeuvres/dubins.h"
#include "tramline/turns/manoeuvres/reeds_shepp.h"

namespace tramline {

LeastSeconds::LeastSeconds(const Machine& machine, double stop_s)
    : turning_(machine.turning),
      radius_m_(std::max(machine.radius_m, kLeastRadius_m)),
      reverses_(!outline_of(machine).tows()),
      changes_s_(2 * turning_.gear_change_s + (turning_.reverse ? 0 : stop_s)),
      fastest_mps_(reverses_ ? std::max(turning_.turning_speed_mps, turning_.reverse_speed_mps)
                             : turning_.turning_speed_mps) {}

Machine slightly_tighter(Machine machine) {
  constexpr double kTighter_share = 1e-7;
  machine.radius_m = (1 - kTighter_share) * std::max(machine.radius_m, kLeastRadius_m);
  return machine;
}

double LeastSeconds::forward(const Pose& left, double lift_m, const Pose& entered, double lower_m) const {
  const double forward_m =
      lift_m + lower_m + dubins_length(moved_on(left, lift_m), moved_on(entered, -lower_m), radius_m_);
  return forward_m / turning_.turning_speed_mps;
}

double LeastSeconds::forward(const Pose& left, const Pose& entered) const {
  return forward(left, turning_.lift_m, entered, turning_.lower_m);
}

double LeastSeconds::between(const Pose& left, const Pose& entered) const {
  return between(left, turning_.lift_m, entered, turning_.lower_m, std::numeric_limits<double>::infinity());
}

double LeastSeconds::between(const Pose& left, double lift_m, const Pose& entered, double lower_m,
                             double known_s) const {
  const double least_m = least_length(left, entered, radius_m_);
  const double least_forward_s = least_m / turning_.turning_speed_mps;
  const double reversing_s = changes_s_ + least_m / fastest_mps_;
  if (reverses_ ? std::min(least_forward_s, reversing_s) >= known_s : least_forward_s >= known_s)
    return known_s;
  const double forward_s = forward(left, lift_m, entered, lower_m);
  if (!reverses_) return forward_s;
  if (reversing_s >= std::min(forward_s, known_s)) return std::min(forward_s, reversing_s);
  return std::min(forward_s, changes_s_ + reeds_shepp_length(left, entered, radius_m_) / fastest_mps_);
}

double LeastSeconds::crude(const Pose& left, const Pose& entered) const {
  return distance(left.at, entered.at) / fastest_mps_;
}

}  // namespace tramline
