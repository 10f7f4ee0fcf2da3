#pragma once
// A lower bound on the cost of a plan with any ways past the obstacles, from the plan with all tracks cut.

#include "tramline/avoidance/choose_detours.h"

namespace tramline {

/// All tracks cut at obstacles (Versleijen fig. 20), tallied.
Avoided all_cut(const AvoidanceTask& task);

/// Whether any track meets an obstacle.
bool meets_obstacles(const AvoidanceTask& task);

/// No choice of ways past the obstacles makes the plan cheaper than this. Land that no detour can reach costs
/// what it costs with all tracks cut. Elsewhere a detour that saves a turn and stops drives the gap it
/// bridges and the way round what stands in it, and no more land is useful than there is: anything worked
/// beyond that is overlap. O(pieces + strips · obstacles + gaps · corners of obstacles and field).
double least_cost_with_detours(const AvoidanceTask& task, const Avoided& cut);

}  // namespace tramline
