#pragma once
// How far an outline gets on its way.

#include "tramline/turns/outline/outline.h"

namespace tramline {

/// How far the outline gets beyond the line through `on_line`, square to it in the direction of the unit
/// vector, m: the maximum over the path of the outline's support function, which a corner of a convex part
/// attains. Negative where it stays before the line. On lines and arcs in closed form; on clothoids, and for
/// a towed implement, by even motions and how far they are off, to kSweptReach_m below at most.
/// Preconditions: the path is not empty; has no reverse where the outline tows.
double swept_reach_m(const SteeredPath& path, const Outline& outline, Point on_line, Point unit);

}  // namespace tramline
