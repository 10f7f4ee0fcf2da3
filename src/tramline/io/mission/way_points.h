#pragma once
// A route as points, each with how the way to it is driven.

#include <vector>

#include "tramline/geometry/angle.h"
#include "tramline/geometry/path/steered_path.h"
#include "tramline/geometry/point.h"
#include "tramline/model/plan.h"

namespace tramline::io {

/// Frame: the field's local metres.
struct WayPoint {
  Point at;         ///< of the middle of the rear axle
  Heading heading;  ///< of the machine there
  Gear gear = Gear::kForward;
  double speed_mps = 0;
  bool work = false;
};

/// The route from its first place to its last; the lines between the points stay within `tolerance_m` of it.
/// Ends of legs are points. O(n) in stretches and points. Preconditions: the plan has a route; tolerance_m >
/// 0.
std::vector<WayPoint> way_points(const Plan& plan, double tolerance_m);

/// Along the lines between the points, m.
double length_of(const std::vector<WayPoint>& route);

}  // namespace tramline::io
