#pragma once
// Versleijen's obstacle category b: obstacles closer together than the working width are one obstacle.

#include "tramline/geometry/polygon/region.h"

namespace tramline {

/// One obstacle for the planner: its shapes, and the land between them that is given up.
struct Cluster {
  Region obstacles;
  Region given_up;
};

/// Groups obstacles whose gap is less than `width_m` (Versleijen table 3), transitively, in the order of
/// their first member. The land between members nearer than that is given up. O(n²) distances.
std::vector<Cluster> clusters(const Region& obstacles, double width_m);

}  // namespace tramline
