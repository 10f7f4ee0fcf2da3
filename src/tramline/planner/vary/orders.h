#pragma once
// Plans with their tracks in other orders.

#include "tramline/planner/whole/route_comparison.h"

namespace tramline {

/// The best plan with each track beside the one before. The quickest order may back out of ends that this one
/// leaves forward, or keep off crop that costs nothing; this one may take longer and cost less. Nothing where
/// it does neither and is known to be near the best, or where the order is given. Precondition, as of the
/// next: there is a plan.
void try_adjacent_order(RouteComparison& plans);

/// The same, without a route.
LaidOut in_adjacent_order(const RouteComparison& plans);

/// Orders of the cheapest plans are looked for longer, as far as that was given up. Nothing where the order
/// is given.
void look_longer_for_orders(RouteComparison& plans);

}  // namespace tramline
