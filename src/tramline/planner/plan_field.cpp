#include "tramline/planner/plan_field.h"

#include <optional>
#include <utility>
#include <vector>

#include "tramline/planner/headland_choice/headland_trial.h"
#include "tramline/planner/headland_choice/room_beyond.h"
#include "tramline/planner/headland_choice/trial_corners.h"
#include "tramline/planner/plans/cheapest_route.h"
#include "tramline/planner/plans/headlands_by_turns.h"
#include "tramline/planner/plans/plan_by_routes.h"
#include "tramline/planner/plans/searched_plan.h"
#include "tramline/planner/warnings.h"
#include "tramline/planner/whole/shorter_ends.h"

namespace tramline {
namespace {

/// A plan takes the place of another, whose bound it does not have, where it costs less by this, EUR.
constexpr double kWorthIt = 0.01;

/// A plan behind given passes, or with their corners worked out and with shorter ends of tracks where its
/// route then costs less.
Plan or_with_cheaper_route(Plan plan, const PlanningProblem& problem, const SearchContext& context) {
  const PlanSettings& settings = problem.settings;
  if (settings.tracks != TrackConstruction::kParallel || plan.subfields.empty() || context.has_to_end())
    return plan;
  const PassesByBoundary none{std::vector<int>(problem.field.outer.size(), 0),
                              std::vector<int>(problem.field.obstacles.size(), 0)};
  const SearchContext laying = context.uncounted().without_bound();
  std::optional<HeadlandTrial> trial =
      headland_trial(problem, plan, as_set(problem, none), Offset::kOfLayout, laying);
  if (!trial) return plan;
  const bool round = settings.route.corners == PassCorners::kRound || plan.headland.passes.empty();
  HeadlandTrial worked = round ? *std::move(trial) : or_with_worked_corners(*std::move(trial));
  HeadlandTrial cheaper = with_shorter_ends(std::move(worked));
  const double saved = whole_cost(plan).euros() - whole_cost(cheaper.draft.plan).euros();
  return saved >= kWorthIt ? finished(std::move(cheaper), laying) : plan;
}

ExplainedPlan planned(PlanningProblem problem, const SearchContext& context, Explain explain) {
  const bool whole =
      problem.settings.aim == Aim::kWholeCost && problem.settings.turns == TurnPlanning::kRoute;
  const Decides decides = whole ? Decides::kWholeCost : Decides::kCostOfTracks;
  if (!compares_routes(problem.settings)) problem.settings.aim = Aim::kCost;
  ExplainedPlan out;
  if (compares_routes(problem.settings))
    out = plan_by_routes(problem, context, explain);
  else if (headlands_follow_turns(problem.settings))
    out = planned_with_headlands_for_turns(problem, decides, context);
  else {
    out = searched_plan(problem, context, explain);
    if (whole) out.plan = or_with_cheaper_route(std::move(out.plan), problem, context);
  }
  if (!out.plan.turns.empty() && out.plan.settings.boundary == EdgeKind::kSoft)
    out.plan.room_beyond_m = room_beyond_edges(out.plan);
  if (context.cut_short() || out.plan.proof.cut_short) mark_cut_short(out.plan);
  return out;
}

}  // namespace

Plan plan_field(const Field& field, const Machine& machine, const Objective& objective,
                const PlanSettings& settings, int threads, const Progress& progress) {
  const PlanningProblem problem = planning_problem(field, machine, objective, settings);
  return planned(problem, SearchContext(threads, progress), Explain::kNo).plan;
}

ExplainedPlan plan_and_explain(const Field& field, const Machine& machine, const Objective& objective,
                               const PlanSettings& settings, int threads, const Progress& progress) {
  const PlanningProblem problem = planning_problem(field, machine, objective, settings);
  return planned(problem, SearchContext(threads, progress), Explain::kYes);
}

}  // namespace tramline
