#pragma once
// Plans with other tracks behind the same headlands.

#include "tramline/planner/whole/route_comparison.h"

namespace tramline {

/// Directions that come near the best plan behind other passes are laid behind its own. Precondition, as of
/// vary_grids(): there is a plan.
void vary_directions(RouteComparison& plans, RouteLayouts& layouts);

/// Curves are looked for behind the passes of the best plan, unless they were; where it hardly works the
/// field behind those of the next best as well. Precondition: there is one.
void vary_curves(RouteComparison& plans, RouteLayouts& layouts);

/// Curves are looked for behind these passes, unless they were.
void vary_curves_behind(RouteComparison& plans, RouteLayouts& layouts, const PassesByBoundary& passes);

/// The search for tracks prices a turn like the quickest one; what turns come to, only routes show. So what
/// is best by the usual prices is laid out behind these passes, too.
void vary_prices(RouteComparison& plans, RouteLayouts& layouts, const PassesByBoundary& passes);

/// Directions all round, where there are few tracks: their turns and ways decide, of which the cost of tracks
/// knows nothing.
void vary_compass(RouteComparison& plans, RouteLayouts& layouts);

/// The tracks of the best plans moved and turned a little: where there are few, turns and ways decide, of
/// which the cost of tracks knows nothing. Of fields without obstacles.
void vary_grids(RouteComparison& plans);

}  // namespace tramline
