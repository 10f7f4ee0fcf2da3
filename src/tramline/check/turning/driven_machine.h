#pragma once
// The places of a machine and its implement along a path, by numerical integration.

#include <array>
#include <vector>

#include "tramline/geometry/path/steered_path.h"
#include "tramline/model/machine.h"

namespace tramline::check {

/// A straight part of the outline, from corner to corner.
using Side = std::array<Point, 2>;

/// Whether an implement follows the machine on a drawbar.
bool tows(const Turning& turning);

struct MachinePlace {
  Point axle;
  Point ahead;            ///< unit vector
  Point implement;        ///< the middle of the line where the implement works
  Point implement_ahead;  ///< unit vector
};

/// The places at most `step_m` apart along the path, its start and its end among them. Lines and curvatures
/// are integrated by the rule of Runge and Kutta; a towed implement is drawn after its hitch, which is exact
/// as the steps become small. Where it turns sharply, steps are shorter. O(length/step).
std::vector<MachinePlace> places_along(const SteeredPath& path, const Machine& machine, double step_m);

/// The outline of the vehicle, its implement, and the drawbar between them.
std::vector<Side> outline_at(const MachinePlace& place, const Machine& machine);

}  // namespace tramline::check
