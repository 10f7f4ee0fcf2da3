#include "tramline/planner/plans/plan_by_routes.h"

#include <algorithm>
#include <cassert>
#include <optional>
#include <utility>
#include <vector>

#include "tramline/geometry/error.h"
#include "tramline/planner/assembly/whole_figures.h"
#include "tramline/planner/headland_choice/headland_trial.h"
#include "tramline/planner/plans/cheapest_route.h"
#include "tramline/planner/plans/headlands_by_turns.h"
#include "tramline/planner/whole/plan_faults.h"
#include "tramline/planner/whole/route_alternative.h"

namespace tramline {
namespace {

/// Subfields and pieces of least cost, without the headlands that are to follow from turns, if any do: of
/// straight tracks, and with curves where these cost less.
std::vector<Plan> layouts_to_begin_with(const PlanningProblem& problem, const SearchContext& context) {
  PlanningProblem bare =
      headlands_follow_turns(problem.settings) ? without_headlands_for_turns(problem) : problem;
  bare.settings.turns = TurnPlanning::kNone;
  const auto layout_of = [&](TrackShape shape) {
    // Curves are looked for in the cells of the sweep as well.
    const SearchContext searching = context.for_layout().without_bound();
    const bool straight = shape == TrackShape::kStraight;
    return searched_plan(with_shape(bare, shape), straight ? searching.without_sweep() : searching,
                         Explain::kNo)
        .plan;
  };
  // Behind headlands that follow from turns, curves are looked for on the land that these leave.
  const bool by_turns = problem.settings.headland_rule == HeadlandRule::kTurns;
  const bool later = by_turns && bare.settings.shape == TrackShape::kAuto;
  std::vector<Plan> out{layout_of(later ? TrackShape::kStraight : bare.settings.shape)};
  if (follow_curves(out.front().subfields)) out.insert(out.begin(), layout_of(TrackShape::kStraight));
  return out;
}

/// Those of a plan, which are as the settings say where no turns decided.
PassesByBoundary passes_of(const OtherKind& plan, const PlanningProblem& problem) {
  if (const auto* const trial = std::get_if<HeadlandTrial>(&plan)) return trial->passes;
  return as_set(problem, {std::vector<int>(problem.field.outer.size(), 0),
                          std::vector<int>(problem.field.obstacles.size(), 0)});
}

/// Straight tracks by the usual prices of tracks, with the headlands that their turns need if any follow
/// them. Where they end is decided by the prices of the problem.
OtherKind by_usual_prices(const PlanningProblem& problem, const SearchContext& context) {
  const PlanningProblem straight = with_shape(problem, TrackShape::kStraight);
  PlanningProblem usual = straight;
  usual.objective = Objective{};
  std::optional<HeadlandTrial> found;
  if (headlands_follow_turns(usual.settings)) found = best_tracks_with_headlands_for_turns(usual, context);
  OtherKind out;
  if (found)
    out = *std::move(found);
  else
    out = planned_without_tracks(usual, context.without_bound()).plan;
  const Plan& like = plan_of(out);
  const PassesByBoundary passes = passes_of(out, straight);
  if (!like.subfields.empty())
    if (auto laid = headland_trial(straight, like, passes, Offset::kOfLayout, context.without_bound()))
      out = *std::move(laid);
  Plan& plan = plan_of(out);
  plan.objective = problem.objective;
  plan.cost = cost(problem.objective, plan.tally);
  plan.settings.shape = problem.settings.shape;
  return out;
}

/// Without headlands round the field, and with no more land beyond its boundary than with them.
PlanningProblem without_headlands_round(PlanningProblem problem) {
  PlanSettings& settings = problem.settings;
  if (settings.headland_rule != HeadlandRule::kTurns) return problem;
  settings.headland_rule = HeadlandRule::kPasses;
  settings.headlands = 0;
  if (settings.boundary == EdgeKind::kSoft) settings.turn_room_m = std::max(0.0, settings.turn_room_m);
  return problem;
}

/// Land on which no track fits; passes may work it all the same.
Plan without_tracks(const PlanningProblem& problem) {
  Plan out;
  out.field = problem.field;
  out.machine = problem.machine;
  return out;
}

/// Of the boundary that was asked for.
ExplainedPlan planned_as_asked(const PlanningProblem& asked, const SearchContext& context, Explain explain) {
  const PlanningProblem problem = with_track_prices(asked);
  // Of the time that a plan takes, over real fields about so much goes by until routes are compared.
  constexpr double kLaidOut = 0.15;
  const bool by_turns = headlands_follow_turns(problem.settings);
  std::vector<Plan> layouts;
  std::optional<Error> no_track;
  try {
    layouts = layouts_to_begin_with(problem, context.for_part(0, kLaidOut));
  } catch (const Error& error) {
    if (!by_turns || error.kind() != ErrorKind::kBadInput) throw;
    no_track = error;
    layouts.push_back(without_tracks(problem));
  }
  const SearchContext comparing = context.for_part(kLaidOut, 1);
  if (!no_track && layouts.front().subfields.empty()) return planned_without_tracks(problem, comparing);
  const auto room_for_turns = [&](LayoutBy by) -> OtherKind {
    if (no_track) throw Error(*no_track);
    const SearchContext deepening = comparing.uncounted().without_bound();
    if (!by_turns) return searched_plan(problem, deepening, Explain::kNo).plan;
    if (by == LayoutBy::kTurns) return with_headlands_for_turns(problem, layouts.back(), deepening);
    return by_usual_prices(by == LayoutBy::kNoHeadland ? without_headlands_round(problem) : problem,
                           comparing.uncounted());
  };
  const Compare compare = explain == Explain::kYes ? Compare::kAll : Compare::kWhatMayWin;
  ComparedRoutes compared = cheapest_route(problem, layouts, room_for_turns, compare, comparing);
  return {std::move(compared.plan), std::nullopt, std::move(compared.all)};
}

/// Whether a plan whose tracks may pass the boundary has so little room that one within it may cost less:
/// tracks that keep within it can be left forward, and those beside it are given up.
bool may_cost_less_within(const Plan& plan) {
  return backs_out_of_tracks(plan) || hardly_works(plan) || whole_cost(plan).without_room > 0;
}

/// The plan of less cost, the first where both cost the same, which tells of what either was compared with.
ExplainedPlan cheaper_of(ExplainedPlan a, ExplainedPlan b) {
  if (whole_cost(b.plan).euros() < whole_cost(a.plan).euros()) std::swap(a, b);
  std::vector<RouteAlternative>& all = a.routes;
  all.insert(all.end(), b.routes.begin(), b.routes.end());
  all = in_order_told(std::move(all), a.plan);
  return a;
}

ExplainedPlan or_within_boundary(ExplainedPlan plan, PlanningProblem problem, const SearchContext& context,
                                 Explain explain) {
  problem.settings.boundary = EdgeKind::kHard;
  ExplainedPlan within;
  try {
    within = planned_as_asked(problem, context.uncounted(), explain);
  } catch (const Error& error) {
    if (error.kind() != ErrorKind::kBadInput) throw;
    return plan;  // no track fits
  }
  return cheaper_of(std::move(plan), std::move(within));
}

}  // namespace

ExplainedPlan plan_by_routes(const PlanningProblem& asked, const SearchContext& context, Explain explain) {
  assert(compares_routes(asked.settings));
  ExplainedPlan out = planned_as_asked(asked, context, explain);
  if (asked.settings.boundary == EdgeKind::kHard || context.has_to_end() || !may_cost_less_within(out.plan))
    return out;
  return or_within_boundary(std::move(out), asked, context, explain);
}

}  // namespace tramline
