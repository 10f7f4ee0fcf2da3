#include "tramline/planner/plans/cheapest_route.h"

#include <algorithm>
#include <cassert>
#include <optional>
#include <utility>

#include "tramline/planner/assembly/finished_plan.h"
#include "tramline/planner/assembly/whole_figures.h"
#include "tramline/planner/vary/corners.h"
#include "tramline/planner/vary/depth.h"
#include "tramline/planner/vary/ends.h"
#include "tramline/planner/vary/left_out_tracks.h"
#include "tramline/planner/vary/obstacles.h"
#include "tramline/planner/vary/orders.h"
#include "tramline/planner/vary/tracks.h"
#include "tramline/planner/whole/plan_faults.h"
#include "tramline/planner/whole/route_alternative.h"
#include "tramline/planner/whole/route_layouts.h"
#include "tramline/planner/whole/track_prices.h"

namespace tramline {
namespace {

/// What is done of a comparison after each of its steps, about as over real fields: its first layouts, their
/// routes, headlands of other depths, and other obstacles with headlands.
constexpr double kBegun = 0.2;
constexpr double kFirstRoutes = 0.5;
constexpr double kDepthFound = 0.75;
constexpr double kObstaclesFound = 0.85;

/// Passes all round take land from tracks, also beside them. Where they leave tracks most of the field that
/// costs less than the ends of open passes, in and out of which the machine has to be turned or backed.
bool open_passes_may_pay(const RouteComparison& plans, Narrow narrow) {
  return narrow == Narrow::kYes || lacks_room(plans.best().draft) || hardly_works(plans.best_plan());
}

/// The cheapest of the layouts to begin with, and of those made from them step by step.
void compare_all(RouteComparison& plans, RouteLayouts& layouts) {
  const SearchContext& context = plans.context();
  for (LaidOut& laid : layouts.to_begin_with()) plans.add(std::move(laid));
  context.reach(kBegun);
  plans.plan_routes({kBegun, kFirstRoutes});
  const Narrow narrow =
      plans.has_best() && passes_work_most(plans.best().prepared) ? Narrow::kYes : Narrow::kNo;
  if (!plans.has_best() || (plans.goes_on() && open_passes_may_pay(plans, narrow))) {
    for (LaidOut& laid : layouts.behind_open_passes()) plans.add(std::move(laid));
    plans.plan_routes({kBegun, kFirstRoutes});
  }
  if (!plans.has_best() || plans.goes_on_varying()) vary_depth(plans, layouts, narrow);
  if (plans.goes_on_varying()) vary_curves(plans, layouts);
  if (plans.goes_on_varying()) vary_directions(plans, layouts);
  if (plans.goes_on_varying()) vary_prices(plans, layouts, PassesByBoundary(plans.best().passes));  // a copy
  context.reach(kDepthFound);
  if (plans.goes_on_varying()) vary_obstacles(plans, layouts);
  if (plans.goes_on_varying()) vary_compass(plans, layouts);
  if (plans.goes_on_varying()) vary_grids(plans);
  if (plans.goes_on()) work_out_corners(plans);
  if (plans.goes_on()) shorten_ends(plans);
  if (plans.goes_on()) try_adjacent_order(plans);
  if (plans.goes_on()) leave_out_tracks(plans);
  if (plans.goes_on()) look_longer_for_orders(plans);
  context.reach(kObstaclesFound);
}

/// What is told besides, however much it costs: no headland, and the best plan in adjacent order.
void add_for_comparison(RouteComparison& plans, RouteLayouts& layouts) {
  const PlanSettings& settings = plans.problem().settings;
  if (settings.headland_rule == HeadlandRule::kTurns) {
    PassesByBoundary none = plans.best().passes;
    std::ranges::fill(none.edges, 0);
    if (auto bare = layouts.laid_out(Alternative::kNoHeadland, plans.best_plan(), none)) {
      ComparedPlan entry{std::move(*bare)};
      plans.plan_route(entry);
      plans.tell_of(entry);
    }
  }
  if (settings.route.order != TrackOrder::kBest) return;
  const bool known = std::ranges::any_of(
      plans.told_of(), [](const RouteAlternative& one) { return one.kind == Alternative::kAdjacent; });
  if (known) return;
  ComparedPlan entry{in_adjacent_order(plans)};
  plans.plan_route(entry);
  plans.tell_of(entry);
}

Plan finished(OtherKind plan, const SearchContext& context) {
  if (auto* const trial = std::get_if<HeadlandTrial>(&plan)) return finished(std::move(*trial), context);
  return std::get<Plan>(std::move(plan));
}

/// `other`: a plan of another kind that costs less than the best one.
ComparedRoutes compared(RouteComparison& plans, std::optional<OtherKind> other) {
  ComparedRoutes out;
  if (other)
    out.plan = finished(*std::move(other), plans.context());
  else
    out.plan = finished(std::move(plans.best_to_finish()), plans.context());
  out.all = in_order_told(plans.told_of(), out.plan);
  return out;
}

}  // namespace

bool compares_routes(const PlanSettings& settings) {
  return settings.aim == Aim::kWholeCost && settings.turns == TurnPlanning::kRoute &&
         settings.shape != TrackShape::kCurved && settings.guide.empty() && !settings.given.divides() &&
         settings.tracks == TrackConstruction::kParallel && settings.strategy == Strategy::kBest;
}

PlanningProblem with_track_prices(PlanningProblem problem) {
  problem.objective = track_prices(problem.machine);
  return problem;
}

ComparedRoutes cheapest_route(const PlanningProblem& problem, const std::vector<Plan>& layouts,
                              const RoomForTurns& room_for_turns, Compare compare,
                              const SearchContext& context) {
  assert(compares_routes(problem.settings) && !layouts.empty());
  RouteComparison plans(problem, compare, context);
  RouteLayouts laid_out(plans.problem(), layouts, context.uncounted());
  compare_all(plans, laid_out);
  if (plans.goes_on() && compare == Compare::kAll) add_for_comparison(plans, laid_out);
  std::optional<OtherKind> other;
  if (!plans.has_best() || plans.goes_on()) other = with_room(plans, room_for_turns);
  ComparedRoutes out = compared(plans, std::move(other));
  // What a search proves of the cost of tracks says nothing about whole routes.
  out.plan.proof = {};
  out.plan.proof.cut_short = context.cut_short() || plans.took_enough();
  return out;
}

}  // namespace tramline
