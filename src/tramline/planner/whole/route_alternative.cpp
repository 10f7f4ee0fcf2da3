#include "tramline/planner/whole/route_alternative.h"

#include <algorithm>

namespace tramline {

const char* name(Alternative alternative) {
  switch (alternative) {
    case Alternative::kSearched:
      return "as searched";
    case Alternative::kLongestSide:
      return "along the longest side";
    case Alternative::kLength:
      return "along the length";
    case Alternative::kUndivided:
      return "undivided";
    case Alternative::kNoHeadland:
      return "no headland";
    case Alternative::kAdjacent:
      return "adjacent order";
    case Alternative::kRoomForTurns:
      return "room for turns";
  }
  return "";
}

RouteAlternative alternative_of(Alternative kind, const Plan& plan) {
  RouteAlternative out;
  out.kind = kind;
  for (const Subfield& subfield : plan.subfields) out.directions.push_back(subfield.direction);
  out.headlands = plan.settings.headlands;
  out.all_round = plan.settings.headland_edges.empty();
  out.cost = whole_cost(plan);
  out.without_room = legs_without_room(plan.route, plan.machine);
  out.dropped =
      static_cast<std::size_t>(std::ranges::count(plan.dropped, DroppedFor::kWay, &DroppedPiece::why));
  return out;
}

}  // namespace tramline
