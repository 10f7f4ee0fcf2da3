#pragma once
// The whole route over a field: tracks, headland passes, and the ways between them.

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "tramline/model/plan.h"
#include "tramline/route/build/lines_beside_boundaries.h"
#include "tramline/route/build/patience.h"
#include "tramline/route/order/lines.h"
#include "tramline/turns/room/allowed_land.h"

namespace tramline {

/// What a route is planned on. All references outlive the call.
struct RouteTask {
  const Field& field;
  const Machine& machine;
  const PlanSettings& settings;
  const Headland& headland;
  const Region& body;               ///< the land of the tracks
  const AllowedLand& turning_land;  ///< turning_land()
  const LinesBesideBoundaries& beside_boundaries;
  const LinesForNarrower& for_narrower;
  Patience patience = Patience::kUsual;
};

/// What a stop to back out counts in the order of a route and in its bound, s: stop_seconds() where the plan
/// is to cost little, and 0 where it is to take little time.
double counted_stop_s(const RouteTask& task);

struct PlannedRoute {
  order::Tour tour;  ///< over the lines
  std::vector<RouteLeg> legs;
  bool gave_up = false;          ///< as of TrackTour, for one of its parts at least
  std::size_t reached = 0;       ///< poses, by searches for ways with room: RoadmapWays::reached()
  std::size_t parts = 1;         ///< of the land with work, between which it has to leave the land
  std::optional<Point> start{};  ///< gates as driven: moved to where the machine has room
  std::optional<Point> end{};
};

/// The route over all lines and headland passes, each once. Headland passes come before all tracks or after
/// them, and closed ones round obstacles, where passes come last, also among them, behind the tracks that end
/// there. The order of the tracks is that of the settings or the best one found; `given` are tours to begin
/// from, of which the first is the one that PlanSettings::skip asks for. Deterministic. Precondition: there
/// is a line or a pass.
PlannedRoute planned_route(const RouteTask& task, const std::vector<order::WorkedLine>& lines,
                           const std::vector<order::Tour>& given);

}  // namespace tramline
