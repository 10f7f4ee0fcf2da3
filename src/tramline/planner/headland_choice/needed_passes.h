#pragma once
// How many headland passes the turns between tracks need, and where.

#include "tramline/model/plan.h"
#include "tramline/planner/headland_choice/passes_by_boundary.h"
#include "tramline/turns/room/allowed_land.h"

namespace tramline {

/// The passes that the turns of a plan without headlands need: for each turn the manoeuvre that needs the
/// fewest at both of its ends, and of those the quickest. A turn takes up the boundary between its two ends;
/// stretches between turns that are shorter than a turn is wide are taken up as well, so that the many edges
/// of a curved side are treated alike. Edges at which no track ends have none. O(pieces · n).
PassesByBoundary needed_passes(const Plan& plan);

/// The passes that a plan with headlands still lacks: where a turn or the way off an end leaves the land by
/// some metres, as many more at the boundary that it leaves there. O(turns without room · n).
PassesByBoundary lacking_passes(const Plan& plan, const AllowedLand& land);

}  // namespace tramline
