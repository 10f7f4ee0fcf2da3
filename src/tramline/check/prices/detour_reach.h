#pragma once
// Where detours may run, and how much longer than their rows they may be.

#include <vector>

#include "tramline/geometry/polygon/region.h"
#include "tramline/model/plan.h"

namespace tramline::check {

/// Obstacles, near one another, that one detour may go round.
struct ObstacleGroup {
  std::vector<Point> corners;
  Box box;
  int ways_round = 0;  ///< detours that one track may make round them
};

/// The groups of all obstacles of a plan and of the land given up about them.
std::vector<ObstacleGroup> obstacle_groups(const Plan& plan, const Region& land);

/// Rows of a plane in which tracks run up, where a detour may replace the rows of a track that meets the
/// group, and the land that it then works.
struct DetourReach {
  double left_m = 0, right_m = 0;  ///< of the group
  Box land;
  double longer_m = 0;  ///< than the rows, at most
};

/// For all directions near `up`, so that nothing of the land, seen from the pivot, moves farther than
/// `stray_m`.
std::vector<DetourReach> detours_along(const Plan& plan, const std::vector<ObstacleGroup>& groups,
                                       Point pivot, Point up, double stray_m);

}  // namespace tramline::check
