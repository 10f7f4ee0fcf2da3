#pragma once
// What the best ways past the obstacles can make of a plan with all tracks cut.

#include "tramline/avoidance/choose_detours.h"

namespace tramline {

/// All tracks cut at obstacles (S1.40), tallied.
Avoided all_cut(const AvoidanceTask& task);

/// Whether any track meets an obstacle.
bool meets_obstacles(const AvoidanceTask& task);

/// No choice of ways past the obstacles makes the plan cheaper than this: what lies where no detour can come
/// costs what it costs with all tracks cut, the rest nothing but a track for each strip that has one.
/// O(pieces + strips · obstacles).
double least_with_detours(const AvoidanceTask& task, const Avoided& cut);

}  // namespace tramline
