#pragma once
// What every manoeuvre has to be.

#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <numbers>
#include <string>

#include "tramline/model/manoeuvre.h"
#include "turns/integration.h"

namespace tramline::testing {

inline Pose pose(double x, double y, double clockwise_degrees) {
  return {{x, y}, Heading::clockwise_from_north(Angle::degrees(clockwise_degrees))};
}

/// The word of a path, letter by letter: a turn goes on where the wheels are not straight between stretches.
inline std::string spelled(const SteeredPath& path) {
  std::string out;
  bool turning = false;
  for (const SteeredStretch& stretch : path) {
    const double curvature = stretch.curvature_at_start + stretch.curvature_at_end;
    const char letter = curvature > 0 ? 'L' : curvature < 0 ? 'R' : 'S';
    const bool onward = turning && stretch.clothoid() == (stretch.curvature_at_end == 0);
    if (!onward) out += stretch.gear == Gear::kForward ? letter : static_cast<char>(std::tolower(letter));
    turning = stretch.clothoid() ? stretch.curvature_at_end != 0 : onward;
  }
  return out;
}

/// Its stretches, driven in small steps, lead from one pose to the other; stretches begin where the one
/// before ends.
inline void expect_leads(const Manoeuvre& manoeuvre, const Pose& from, const Pose& to, int steps = 500) {
  const double size = 1 + distance(from.at, to.at) + length(manoeuvre.path);
  EXPECT_LE(difference(driven(from, manoeuvre.path, steps).back(), to), 1e-9 * size) << manoeuvre.word;
  EXPECT_EQ(spelled(manoeuvre.path), manoeuvre.word);
  for (std::size_t i = 0; i < manoeuvre.path.size(); ++i) {
    const Pose before = i == 0 ? from : end_of(manoeuvre.path[i - 1]);
    EXPECT_LE(difference(driven_pose(manoeuvre.path[i].start), before), 1e-9 * size) << manoeuvre.word;
    EXPECT_GE(manoeuvre.path[i].length_m, 0) << manoeuvre.word;
  }
}

/// Nowhere is it tighter than the radius.
inline void expect_no_tighter(const Manoeuvre& manoeuvre, double radius_m) {
  for (const SteeredStretch& stretch : manoeuvre.path)
    EXPECT_LE(std::max(std::abs(stretch.curvature_at_start), std::abs(stretch.curvature_at_end)),
              (1 + 1e-9) / radius_m)
        << manoeuvre.word;
}

/// The wheels are straight ahead at both ends and never jump but at changes of gear, and turn no faster than
/// the sharpness of each gear allows, 1/m².
inline void expect_steerable(const Manoeuvre& manoeuvre, double forward, double reverse) {
  const SteeredPath& path = manoeuvre.path;
  if (path.empty()) return;
  EXPECT_EQ(path.front().curvature_at_start, 0) << manoeuvre.word;
  EXPECT_EQ(path.back().curvature_at_end, 0) << manoeuvre.word;
  for (std::size_t i = 0; i < path.size(); ++i) {
    const double change = std::abs(path[i].curvature_at_end - path[i].curvature_at_start);
    const double allowed = path[i].gear == Gear::kForward ? forward : reverse;
    EXPECT_LE(change, allowed * path[i].length_m * (1 + 1e-8)) << manoeuvre.word;
    if (i > 0 && path[i].gear == path[i - 1].gear) {
      EXPECT_EQ(path[i].curvature_at_start, path[i - 1].curvature_at_end) << manoeuvre.word;
    }
  }
}

}  // namespace tramline::testing
