#pragma once
// The land that an autopilot keeps a machine on.

#include <string>
#include <vector>

#include "tramline/io/mission/way_points.h"
#include "tramline/model/plan.h"

namespace tramline::io {

/// Rings in the field's local metres. An autopilot that meets a fence stops, so there is none where the route
/// leads through.
struct Geofence {
  std::vector<Ring> stay_inside;
  std::vector<Ring> stay_outside;
  std::vector<std::string> notes;  ///< what has no fence, and why: sentences
};

/// The field's boundary, and its obstacles but the passable ones. O(points · vertices).
Geofence geofence_of(const Plan& plan, const std::vector<WayPoint>& route);

}  // namespace tramline::io
