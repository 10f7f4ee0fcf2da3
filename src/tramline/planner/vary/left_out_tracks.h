#pragma once
// Plans without the tracks that are not worth their ways.

#include "tramline/planner/whole/route_comparison.h"

namespace tramline {

/// Tracks are left out of the plans that may then cost less than the best one. Precondition: there is one.
void leave_out_tracks(RouteComparison& plans);

}  // namespace tramline
