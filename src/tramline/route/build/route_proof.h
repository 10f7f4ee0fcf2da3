#pragma once
// What no route over the same pieces and passes takes less than.

#include <vector>

#include "tramline/route/build/least_seconds.h"
#include "tramline/route/build/planned_route.h"

namespace tramline {

/// Node prices and the bound that they prove (RouteProof), for a route whose tour and legs are planned.
RouteProof route_proof(const RouteTask& task, const std::vector<order::WorkedLine>& lines,
                       const PlannedRoute& route, const LeastSeconds& least);

}  // namespace tramline
