#pragma once
// How far a machine gets to a side while it drives a steered path.

#include "tramline/geometry/path/steered_path.h"
#include "tramline/geometry/point.h"

namespace tramline {

/// The farthest that a point fixed to the machine gets in a direction, metres from the place where the axle's
/// middle is at the start of the path: the greatest dot(position − start, direction). `direction` is a unit
/// vector; `ahead_and_left` is the point in the machine's own frame, from the middle of its axle: x ahead,
/// y to the left. The axle's middle itself gives at least 0; a point behind it may stay below. 0 for a path
/// without stretches.
///
/// Exact: on an arc the point runs on a circle about the same centre, and the extreme inside it counts; on a
/// clothoid the places are found at which the point moves across the direction, in closed form for points on
/// the axle, otherwise by bisection between the places where that function turns (a cubic). O(stretches).
double reach(const SteeredPath& path, Point direction, Point ahead_and_left = {0, 0});

}  // namespace tramline
