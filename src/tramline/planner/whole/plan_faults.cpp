#include "tramline/planner/whole/plan_faults.h"

#include <algorithm>

namespace tramline {
namespace {

/// A plan lacks room where more than one track in so many is backed out of or into.
constexpr std::ptrdiff_t kSeldomBacksOut = 4;
/// No more tracks than these are few, and next to none.
constexpr std::size_t kFewTracks = 16, kNextToNone = 4;
constexpr double kMostOfCost = 0.5;

std::ptrdiff_t back_outs(const Plan& plan) {
  return std::count_if(plan.route.legs.begin(), plan.route.legs.end(),
                       [](const RouteLeg& leg) { return leg.kind == LegKind::kBackOut; });
}

}  // namespace

bool backs_out(const Plan& plan) { return back_outs(plan) > 0; }

bool leaves_land(const PlanDraft& draft) {
  return legs_without_room(draft.plan.route, draft.plan.machine) + 1 > draft.parts;
}

bool lacks_room(const PlanDraft& draft) {
  return leaves_land(draft) || kSeldomBacksOut * back_outs(draft.plan) > std::ssize(draft.plan.pieces);
}

bool has_few_tracks(const Plan& plan) { return plan.pieces.size() <= kFewTracks; }

bool hardly_works(const Plan& plan) {
  const WholeCost cost = whole_cost(plan);
  return has_few_tracks(plan) && cost.missed + cost.stops + cost.without_room > kMostOfCost * cost.euros();
}

bool hardly_works_any_track(const Plan& plan) {
  return plan.pieces.size() <= kNextToNone && hardly_works(plan);
}

}  // namespace tramline
