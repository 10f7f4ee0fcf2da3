#include "tramline/planner/whole/plan_faults.h"

#include <algorithm>

namespace tramline {
namespace {

/// A plan lacks room where more than one track in so many is backed out of or into.
constexpr std::ptrdiff_t kSeldomBacksOut = 4;
/// No more tracks than these are few, and next to none.
constexpr std::size_t kFewTracks = 16, kNextToNone = 4;
constexpr double kMostOfCost = 0.5;

/// How often a track comes before or after backing out. Out of corners of passes all round the machine backs
/// wherever it pays, however much room there is.
std::ptrdiff_t backs_out_of_tracks(const Route& route) {
  std::ptrdiff_t out = 0, since_work = 0;
  bool after_track = false;
  for (const RouteLeg& leg : route.legs) {
    if (leg.kind == LegKind::kBackOut) ++since_work;
    if (!leg.work) continue;
    const bool track = leg.piece.has_value();
    if (track || after_track) out += since_work;
    since_work = 0;
    after_track = track;
  }
  return out + (after_track ? since_work : 0);
}

}  // namespace

bool backs_out_of_tracks(const Plan& plan) { return backs_out_of_tracks(plan.route) > 0; }

bool leaves_land(const PlanDraft& draft) {
  return legs_without_room(draft.plan.route, draft.plan.machine) + 1 > draft.parts;
}

bool lacks_room(const PlanDraft& draft) {
  return leaves_land(draft) ||
         kSeldomBacksOut * backs_out_of_tracks(draft.plan.route) > std::ssize(draft.plan.pieces);
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
