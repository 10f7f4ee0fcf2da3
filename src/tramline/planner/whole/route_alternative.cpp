#include "tramline/planner/whole/route_alternative.h"

#include <algorithm>

namespace tramline {
namespace {

/// Directions nearer to one another are about the same.
constexpr double kAboutTheSame_deg = 5;

/// Whether each of these directions is about the same as one of the others.
bool all_among(const std::vector<Direction>& these, const std::vector<Direction>& others) {
  return std::ranges::all_of(these, [&](Direction one) {
    return std::ranges::any_of(
        others, [&](Direction other) { return angle_between(one, other).degrees() < kAboutTheSame_deg; });
  });
}

bool are_alike(const RouteAlternative& a, const RouteAlternative& b) {
  return a.kind == b.kind && a.headlands == b.headlands && a.all_round == b.all_round &&
         all_among(a.directions, b.directions) && all_among(b.directions, a.directions);
}

/// Of those that are alike the first.
std::vector<RouteAlternative> without_alike(const std::vector<RouteAlternative>& all) {
  std::vector<RouteAlternative> out;
  for (const RouteAlternative& one : all)
    if (std::ranges::none_of(out, [&](const RouteAlternative& other) { return are_alike(one, other); }))
      out.push_back(one);
  return out;
}

void put_first(const Plan& planned, std::vector<RouteAlternative>& all) {
  if (!planned.route.planned()) return;
  const double euros = whole_cost(planned).euros();
  const auto at =
      std::ranges::find_if(all, [&](const RouteAlternative& one) { return one.cost.euros() == euros; });
  if (at != all.end()) std::rotate(all.begin(), at, at + 1);
}

}  // namespace

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
    case Alternative::kMovedLines:
      return "on moved lines";
    case Alternative::kWorkedCorners:
      return "corners worked out";
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

std::vector<RouteAlternative> in_order_told(std::vector<RouteAlternative> all, const Plan& planned) {
  std::ranges::stable_sort(all, [](const RouteAlternative& a, const RouteAlternative& b) {
    return a.cost.euros() < b.cost.euros();
  });
  put_first(planned, all);
  return without_alike(all);
}

}  // namespace tramline
