#include "tramline/route/build/least_seconds.h"

#include <algorithm>
#include <cmath>

#include "tramline/route/axle/axle_path.h"
#include "tramline/turns/manoeuvres/dubins.h"
#include "tramline/turns/manoeuvres/reeds_shepp.h"

namespace tramline {
namespace {

/// No way is shorter, whatever its gears: on circles of the radius and wider ones the heading changes by no
/// more than the length over the radius.
double least_reversing_m(const Pose& from, const Pose& to, double radius_m) {
  const Point a = from.heading.unit(), b = to.heading.unit();
  const double turned = std::atan2(std::abs(cross(a, b)), dot(a, b));
  return std::max(distance(from.at, to.at), radius_m * turned);
}

}  // namespace

LeastSeconds::LeastSeconds(const Machine& machine)
    : turning_(machine.turning),
      radius_m_(std::max(machine.radius_m, kLeastRadius_m)),
      reverses_(!outline_of(machine).tows()),
      fastest_mps_(reverses_ ? std::max(turning_.turning_speed_mps, turning_.reverse_speed_mps)
                             : turning_.turning_speed_mps) {}

double LeastSeconds::forward(const Pose& left, const Pose& entered) const {
  const double straight_m = turning_.lift_m + turning_.lower_m;
  const double forward_m = straight_m + dubins_length(moved_on(left, turning_.lift_m),
                                                      moved_on(entered, -turning_.lower_m), radius_m_);
  return forward_m / turning_.turning_speed_mps;
}

double LeastSeconds::between(const Pose& left, const Pose& entered) const {
  const double forward_s = forward(left, entered);
  const double changes_s = 2 * turning_.gear_change_s;
  if (!reverses_ || changes_s + least_reversing_m(left, entered, radius_m_) / fastest_mps_ >= forward_s)
    return forward_s;
  return std::min(forward_s, changes_s + reeds_shepp_length(left, entered, radius_m_) / fastest_mps_);
}

double LeastSeconds::crude(const Pose& left, const Pose& entered) const {
  return distance(left.at, entered.at) / fastest_mps_;
}

}  // namespace tramline
