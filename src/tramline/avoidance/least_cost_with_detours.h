#pragma once
// What the best ways past the obstacles can make of a plan with all tracks cut.

#include "tramline/avoidance/choose_detours.h"

namespace tramline {

/// All tracks cut at obstacles (S1.40), tallied.
Avoided all_cut(const AvoidanceTask& task);

/// Whether any track meets an obstacle.
bool meets_obstacles(const AvoidanceTask& task);

/// No choice of ways past the obstacles makes the plan cheaper than this. What lies where no detour can come
/// costs what it costs with all tracks cut. Elsewhere a detour that saves a turn and stops drives the gap it
/// bridges and the way aside round what stands in it, and no more ground is useful than there is: what is
/// worked beyond that is overlap. O(pieces + strips · obstacles + gaps · corners of obstacles and field).
double least_cost_with_detours(const AvoidanceTask& task, const Avoided& cut);

}  // namespace tramline
