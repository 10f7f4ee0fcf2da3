#pragma once
// Plans with headlands round other obstacles.

#include "tramline/planner/whole/route_comparison.h"

namespace tramline {

/// Obstacles with headlands lose them, and those without get them, one at a time; of several passes fewer are
/// tried, no more than along the edges, as long as that costs less. Then tracks, straight and curved, are
/// looked for behind no headlands round obstacles, behind all that turns need, and behind one pass round
/// each. Nothing where these passes are given, or in fields of many obstacles. Precondition: there is a plan.
void vary_obstacles(RouteComparison& plans, RouteLayouts& layouts);

}  // namespace tramline
