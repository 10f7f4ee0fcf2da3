#pragma once
// Steered paths driven in small steps, to check them without their formulas.

#include <cmath>
#include <vector>

#include "tramline/geometry/path/steered_path.h"

namespace tramline::testing {

/// Where a machine is, with the anticlockwise angle from +x to its heading, not reduced.
struct DrivenPose {
  double x = 0;
  double y = 0;
  double angle = 0;
};

inline DrivenPose driven_pose(const Pose& pose) {
  return {pose.at.x, pose.at.y, 0.5 * std::numbers::pi - pose.heading.angle().radians()};
}

/// All poses on the way over the stretches, one after the other from the given start: the classical method of
/// Runge and Kutta over lengths and curvatures, the stretches' own start poses ignored.
inline std::vector<DrivenPose> driven(const Pose& start, const SteeredPath& path, int steps_a_stretch = 400) {
  std::vector<DrivenPose> poses = {driven_pose(start)};
  for (const SteeredStretch& stretch : path) {
    const double sense = stretch.gear == Gear::kForward ? 1 : -1;
    const double step = stretch.length_m / steps_a_stretch;
    DrivenPose pose = poses.back();
    const auto curvature = [&](double share) {
      return stretch.curvature_at_start + share * (stretch.curvature_at_end - stretch.curvature_at_start);
    };
    for (int i = 0; i < steps_a_stretch; ++i) {
      // x' = s cos θ, y' = s sin θ, θ' = s κ; κ is given, so θ at the middle of the step is known to the
      // order of the method
      const double k0 = curvature(i / static_cast<double>(steps_a_stretch));
      const double k1 = curvature((i + 0.5) / steps_a_stretch);
      const double k2 = curvature((i + 1.0) / steps_a_stretch);
      const double middle = pose.angle + sense * step * (5 * k0 + 8 * k1 - k2) / 24;
      const double end = pose.angle + sense * step * (k0 + 4 * k1 + k2) / 6;
      pose.x += sense * step * (std::cos(pose.angle) + 4 * std::cos(middle) + std::cos(end)) / 6;
      pose.y += sense * step * (std::sin(pose.angle) + 4 * std::sin(middle) + std::sin(end)) / 6;
      pose.angle = end;
      poses.push_back(pose);
    }
  }
  return poses;
}

/// How far two poses differ: metres, and radians of heading as metres on a circle of a metre.
inline double difference(const DrivenPose& a, const Pose& b) {
  const DrivenPose other = driven_pose(b);
  return std::hypot(a.x - other.x, a.y - other.y) +
         std::abs(std::remainder(a.angle - other.angle, 2 * std::numbers::pi));
}

}  // namespace tramline::testing
