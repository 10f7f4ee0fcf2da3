#include <algorithm>
#include <vector>

#include "tramline/render/page/map_symbols.h"
#include "tramline/render/plan/layers.h"

namespace tramline::render {
namespace {

Colour colour_of_leg(const RouteLeg& leg) {
  if (leg.missing_m > 0) return kNoRoomColour;
  if (leg.kind == LegKind::kBackOut) return kBackOutColour;
  return leg.kind == LegKind::kTransit ? kTransitColour : kTurnColour;
}

enum class Room { kEnough, kMissing };

Room room_of(const RouteLeg& leg) { return leg.missing_m > 0 ? Room::kMissing : Room::kEnough; }

void draw_legs(Canvas& canvas, const Plan& plan, Room room) {
  const double k = canvas.scale();
  const double thickness = std::clamp(0.25 * swath_px(canvas, plan), 0.5 * k, kTurnLine * k);
  for (const RouteLeg& leg : plan.route.legs) {
    if (leg.work || room_of(leg) != room) continue;
    const Path way = trace(leg.path, sagitta_m(canvas.view()));
    if (way.empty()) continue;
    Stroke stroke{colour_of_leg(leg), thickness};
    if (leg.gear == Gear::kReverse) stroke = {colour_of_leg(leg), thickness, {3 * thickness, 3 * thickness}};
    curve(canvas, way, stroke);
  }
}

}  // namespace

void draw_route(Canvas& canvas, const Plan& plan) { draw_legs(canvas, plan, Room::kEnough); }

void draw_ways_without_room(Canvas& canvas, const Plan& plan) { draw_legs(canvas, plan, Room::kMissing); }

void draw_route_ends(Canvas& canvas, const Plan& plan) {
  const auto has_way = [](const RouteLeg& leg) { return !leg.path.empty(); };
  const auto first = std::ranges::find_if(plan.route.legs, has_way);
  if (first == plan.route.legs.end()) return;
  const auto last = std::find_if(plan.route.legs.rbegin(), plan.route.legs.rend(), has_way);
  draw_route_mark(canvas, canvas.view().to_page(end_of(last->path.back()).at), kRouteEndColour);
  draw_route_mark(canvas, canvas.view().to_page(first->path.front().start.at), kRouteStartColour);
}

}  // namespace tramline::render
