#pragma once
// What no route over the same pieces and passes takes less than.

#include <vector>

#include "tramline/route/build/planned_route.h"

namespace tramline {

/// Node prices and the bound that they prove (RouteProof), for the legs of a route that works lines in the
/// order of a tour between the gates of its settings. `route`: of a plan for the same task.
RouteProof route_proof(const RouteTask& task, const std::vector<order::WorkedLine>& lines,
                       const order::Tour& tour, const Route& route);

}  // namespace tramline
