#pragma once
// Machines on convex land, and ways that they drive there at random.

#include <optional>
#include <random>
#include <vector>

#include "tramline/geometry/path/steered_path.h"
#include "tramline/geometry/polygon/region.h"
#include "tramline/model/machine.h"

namespace tramline::testing {

struct DriveScene {
  Machine machine;
  Ring land;  ///< convex, anticlockwise
  Pose from;  ///< with room for the machine
  Gear gear = Gear::kForward;

  /// Of the machine's outline, the axle at the origin and pointing along x.
  std::vector<Point> corners() const;
};

/// Bars of 3 to 24 m on land of up to 70 by 90 m; nullopt where the machine has no room.
std::optional<DriveScene> random_drive_scene(std::mt19937_64& random);

/// On from the scene's pose in its gear, by arcs and straight stretches as long as they have room.
SteeredPath driven_at_random(const DriveScene& scene, std::mt19937_64& random);

}  // namespace tramline::testing
