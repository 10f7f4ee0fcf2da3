#pragma once
// The plan whose whole route costs least.

#include <vector>

#include "tramline/planner/plan_field.h"
#include "tramline/planner/planning_problem.h"
#include "tramline/planner/search_context.h"
#include "tramline/planner/vary/other_kinds.h"
#include "tramline/planner/whole/route_comparison.h"

namespace tramline {

/// Whether plans are to be compared by their routes.
bool compares_routes(const PlanSettings& settings);

/// The problem with the prices of tracks that follow from the rates of its machine (track_prices()).
PlanningProblem with_track_prices(PlanningProblem problem);

struct ComparedRoutes {
  Plan plan;                          ///< the cheapest
  std::vector<RouteAlternative> all;  ///< the plan first, then from the cheapest
};

/// Compares plans by what their whole routes cost (whole_cost()):
/// the tracks of `layouts`, those of least cost behind the headlands, also along curves or by the usual
/// prices of tracks, and tracks along the longest side and along the length of the field. Where headlands
/// follow from turns they go all round the field, as many as the shallowest turn of the machine needs, and
/// one more or less as long as that costs less, and none to some more where the cheapest hardly works the
/// field; or only where tracks of a layout end. Obstacles have their
/// headlands if that costs less. Routes are planned in the order of route_floor(), and not at all where they
/// cannot be expected to cost less than the cheapest so far, except to compare all. If the cheapest has legs
/// without room or backs out often, the plan of `room_for_turns` is compared as well, and where there are few
/// tracks that by usual prices; if it hardly works the field with next to no tracks that without headlands.
/// Tracks are left out where the ways to them cost more than their land is worth. The first among equals is
/// taken. Deterministic for any number of threads. `layouts`: subfields and pieces, without the headlands
/// that follow from turns; the first one, which is straight, says how many passes obstacles need; one without
/// subfields where no track fits. Not empty.
/// Throws kBadInput where no plan has a track. Precondition: compares_routes().
ComparedRoutes cheapest_route(const PlanningProblem& problem, const std::vector<Plan>& layouts,
                              const RoomForTurns& room_for_turns, Compare compare,
                              const SearchContext& context);

}  // namespace tramline
