#include "tramline/planner/vary/other_kinds.h"

#include <utility>
#include <vector>

#include "tramline/geometry/error.h"
#include "tramline/planner/assembly/whole_figures.h"
#include "tramline/planner/whole/plan_faults.h"
#include "tramline/planner/whole/route_alternative.h"

namespace tramline {
namespace {

std::vector<LayoutBy> kinds_to_try(const RouteComparison& plans) {
  std::vector<LayoutBy> out;
  const bool lacks = !plans.has_best() || lacks_room(plans.best().draft);
  if (lacks) out.push_back(LayoutBy::kTurns);
  if (lacks && (!plans.has_best() || has_few_tracks(plans.best_plan())))
    out.push_back(LayoutBy::kUsualPrices);
  if (!plans.has_best() || hardly_works_any_track(plans.best_plan())) out.push_back(LayoutBy::kNoHeadland);
  return out;
}

bool is_cheaper(RouteComparison& plans, const Plan& plan, double least) {
  if (!plan.route.planned()) return true;
  plans.tell_of(alternative_of(Alternative::kRoomForTurns, plan));
  return plans.told_of().back().cost.euros() < least;
}

}  // namespace

const Plan& plan_of(const OtherKind& other) {
  if (const auto* const trial = std::get_if<HeadlandTrial>(&other)) return trial->draft.plan;
  return std::get<Plan>(other);
}

Plan& plan_of(OtherKind& other) {
  if (auto* const trial = std::get_if<HeadlandTrial>(&other)) return trial->draft.plan;
  return std::get<Plan>(other);
}

std::optional<OtherKind> with_room(RouteComparison& plans, const RoomForTurns& room_for_turns) {
  const std::vector<LayoutBy> kinds = kinds_to_try(plans);
  std::optional<OtherKind> out;
  for (std::size_t i = 0; i < kinds.size() && !(out && plans.has_to_end()); ++i) {
    const double least = out ? whole_cost(plan_of(*out)).euros() : plans.least_price();
    try {
      OtherKind other = room_for_turns(kinds[i]);
      if (is_cheaper(plans, plan_of(other), least)) out = std::move(other);
    } catch (const Error& error) {
      const bool last = i + 1 == kinds.size();
      if ((!plans.has_best() && !out && last) || error.kind() != ErrorKind::kBadInput) throw;
    }
  }
  return out;
}

}  // namespace tramline
