#include "tramline/planner/plan_field.h"

#include "tramline/planner/headland_choice/room_beyond.h"
#include "tramline/planner/plans/cheapest_route.h"
#include "tramline/planner/plans/headlands_by_turns.h"
#include "tramline/planner/plans/plan_by_routes.h"
#include "tramline/planner/plans/searched_plan.h"
#include "tramline/planner/warnings.h"

namespace tramline {
namespace {

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
  else
    out = searched_plan(problem, context, explain);
  if (!out.plan.turns.empty() && out.plan.settings.boundary == EdgeKind::kSoft)
    out.plan.room_beyond_m = room_beyond_edges(out.plan);
  if (context.cut_short()) mark_cut_short(out.plan);
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
