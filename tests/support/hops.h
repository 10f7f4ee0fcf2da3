#pragma once
// How far a plan's pieces lie apart as they are driven, by a road of its own: the planner is not asked.

#include <vector>

#include "tramline/model/plan.h"

namespace tramline::testing_support {

/// The straight lines from the end of each piece to the start of the next, but for crossings.
struct Hops {
  int count = 0;
  double length_m = 0;
  int through_obstacles = 0;  ///< more than 0.1 m of the hop lies in obstacles that are not passable
  int far_outside = 0;        ///< somewhere outside the field, more than a working width from its edge
};
Hops hops_of(const Plan& plan);

/// Length of all hops of a nearest-neighbour tour over the same ends, m: from the first end of the first
/// piece, always to the nearest end not driven yet. What crossings join is driven in one go. O(n²).
double nearest_neighbour_m(const std::vector<TrackPiece>& pieces);

}  // namespace tramline::testing_support
