#pragma once
// Plans whose tracks end early, or begin late, where the machine then turns at once.

#include "tramline/planner/whole/route_comparison.h"

namespace tramline {

/// Ends of tracks are shortened in the plans that may then cost less than the best one. Precondition: there
/// is one.
void shorten_ends(RouteComparison& plans);

}  // namespace tramline
