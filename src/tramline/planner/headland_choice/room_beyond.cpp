#include "tramline/planner/headland_choice/room_beyond.h"

#include <algorithm>

#include "tramline/planner/headland_choice/boundary_ahead.h"
#include "tramline/route/turning/planned_turns.h"
#include "tramline/turns/outline/outline.h"
#include "tramline/turns/outline/swept_reach.h"

namespace tramline {

std::vector<double> room_beyond_edges(const Plan& plan) {
  const Outline outline = outline_of(plan.machine);
  const double near_m = 4 * (plan.machine.width_m + plan.machine.radius_m);
  std::vector<double> out(plan.field.outer.size(), 0);
  const auto add = [&](const Pose& end, Point ahead, const SteeredPath& path) {
    const auto place = boundary_ahead(plan.field, {end.at, Heading::from_to({0, 0}, ahead)}, near_m, near_m);
    if (!place || place->obstacle) return;
    const double beyond_m = swept_reach_m(path, outline, plan.field.outer[place->edge], place->outward);
    out[place->edge] = std::max(out[place->edge], beyond_m);
  };
  for (const PlannedTurn& turn : plan.turns) {
    if (turn.manoeuvre.path.empty() || turn.state == TurnState::kApart) continue;
    const Hop hop = hop_between(plan.pieces[turn.after], plan.pieces[turn.after + 1]);
    add(hop.end, hop.end.heading.unit(), turn.manoeuvre.path);
    add(hop.start, -1.0 * hop.start.heading.unit(), turn.manoeuvre.path);
  }
  return out;
}

}  // namespace tramline
