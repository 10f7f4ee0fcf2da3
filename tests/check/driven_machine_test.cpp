// An implement behind its drawbar, as the verifier draws it, against the equation of its angle.

#include "tramline/check/turning/driven_machine.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace tramline::check::driven_machine_test {

constexpr double kDrawbar_m = 2.66;

/// Round half a circle, and so much straight on.
SteeredPath half_circle(double radius_m, double straight_m) {
  SteeredPath out{arc_from({{3, 5}, Heading::clockwise_from_north(Angle::degrees(30))},
                           std::numbers::pi * radius_m, 1 / radius_m, Gear::kForward)};
  out.push_back(arc_from(end_of(out.back()), straight_m, 0, Gear::kForward));
  return out;
}

/// From the drawbar to the machine's heading at the end of the way, rad.
double angle_at_end(const SteeredPath& path) {
  Machine machine;
  machine.turning.implement = Coupling::kTowed;
  machine.turning.drawbar_m = kDrawbar_m;
  const MachinePlace last = places_along(path, machine, 0.25).back();
  return std::atan2(cross(last.implement_ahead, last.ahead), dot(last.implement_ahead, last.ahead));
}

/// With the hitch at the axle the angle b grows by 1/r of the way on an arc, and falls by sin b / L: by the
/// midpoint of each of many steps. On a straight line tan b/2 falls by e for each L.
double angle_by_rate(double radius_m, double straight_m) {
  constexpr int kSteps = 20000;
  const double step_m = std::numbers::pi * radius_m / kSteps;
  const auto rate = [&](double angle) { return 1 / radius_m - std::sin(angle) / kDrawbar_m; };
  double b = 0;
  for (int i = 0; i < kSteps; ++i) b += step_m * rate(b + 0.5 * step_m * rate(b));
  return 2 * std::atan(std::tan(0.5 * b) * std::exp(-straight_m / kDrawbar_m));
}

TEST(DrivenMachine, DrawsAnImplementAsItsAngleTurns) {
  for (const double radius_m : {1.0, 2.0, 6.0})
    for (const double straight_m : {0.1, 1.0, 8.0})
      EXPECT_NEAR(angle_at_end(half_circle(radius_m, straight_m)), angle_by_rate(radius_m, straight_m), 1e-5)
          << radius_m << " m, " << straight_m << " m";
  // The tightest bends the drawbar so far that the machine pushes it.
  EXPECT_GT(angle_by_rate(1, 0.1), 0.5 * std::numbers::pi);
}

}  // namespace tramline::check::driven_machine_test
