#include "tramline/planner/vary/orders.h"

#include <cassert>

#include "tramline/planner/whole/plan_faults.h"

namespace tramline {
namespace {

bool is_given(const RouteComparison& plans) {
  return plans.problem().settings.route.order != TrackOrder::kBest;
}

}  // namespace

LaidOut in_adjacent_order(const RouteComparison& plans) {
  LaidOut out{Alternative::kAdjacent, plans.best()};
  out.trial.problem.settings.route.order = TrackOrder::kBySpacing;
  return out;
}

void try_adjacent_order(RouteComparison& plans) {
  assert(plans.has_best());
  if (is_given(plans)) return;
  const PlanDraft& best = plans.best().draft;
  if (best.gave_up || backs_out_of_tracks(best.plan) || best.plan.route.over_tracks_m > 0)
    plans.improves(in_adjacent_order(plans));
}

void look_longer_for_orders(RouteComparison& plans) {
  assert(plans.has_best());
  if (is_given(plans)) return;
  for (const std::size_t i : worth_ordering_longer(plans.plans(), plans.least_price())) {
    if (plans.has_to_end()) return;
    if (plans.plans()[i].laid.trial.draft.gave_up) plans.improves_in_order(i);
  }
}

}  // namespace tramline
