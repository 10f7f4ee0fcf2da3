// A plan that was changed by hand, laid once.

#include <fmt/format.h>

#include <optional>
#include <utility>

#include "tramline/geometry/error.h"
#include "tramline/planner/assembly/finished_plan.h"
#include "tramline/planner/curved/along_guide.h"
#include "tramline/planner/given/given_search.h"
#include "tramline/planner/headland_choice/foreseen_passes.h"
#include "tramline/planner/headland_choice/headland_trial.h"
#include "tramline/planner/headland_choice/relaid.h"
#include "tramline/planner/headland_choice/trial_corners.h"
#include "tramline/planner/plan_field.h"
#include "tramline/planner/plans/cheapest_route.h"
#include "tramline/planner/prepare_field.h"
#include "tramline/planner/search/straight_search.h"
#include "tramline/planner/warnings.h"

namespace tramline {
namespace {

/// The passes that lie along each edge and round each obstacle of a plan.
PassesByBoundary passes_of(const Plan& plan) {
  PassesByBoundary out{plan.settings.headland_edges, plan.headland.obstacle_passes};
  if (out.edges.empty()) out.edges.assign(plan.field.outer.size(), plan.settings.headlands);
  out.obstacles.resize(plan.field.obstacles.size(), 0);
  return out;
}

void require_same_shape(const Plan& before, const Field& field) {
  if (before.field.outer.size() != field.outer.size() ||
      before.field.obstacles.size() != field.obstacles.size())
    throw bad_input(fmt::format(
        "the plan to be edited was made for another shape of field '{}': plan the field anew", field.id));
  if (before.subfields.empty())
    throw bad_input(
        fmt::format("the plan of field '{}' to be edited has no tracks: plan the field anew", field.id));
}

/// Where routes decide, tracks are priced as by the search for the plan before.
PlanningProblem edit_problem(const Field& field, const Machine& machine, const Objective& objective,
                             const PlanSettings& settings) {
  PlanningProblem out = planning_problem(field, machine, objective, settings);
  if (out.settings.aim == Aim::kWholeCost && out.settings.turns == TurnPlanning::kRoute)
    out = with_track_prices(std::move(out));
  if (!compares_routes(out.settings)) out.settings.aim = Aim::kCost;
  return out;
}

std::optional<PreparedField> prepared_with(const PlanningProblem& problem, const PassesByBoundary& passes) {
  const bool none =
      problem.settings.headlands == 0 && problem.settings.headland_edges.empty() && deepest(passes) == 0;
  return none ? field_without_headlands(problem) : field_behind(problem, passes.obstacles);
}

SearchResult of_candidate(Candidate candidate) {
  SearchResult out;
  out.best = std::move(candidate);
  out.directions_tried = 1;
  return out;
}

/// The one layout.
SearchResult laid_by_hand(const PlanningProblem& problem, const PreparedField& prepared, const Plan& before,
                          const SearchContext& context) {
  if (area(prepared.ground.plannable) == 0) return {};
  const PlanSettings& settings = problem.settings;
  if (settings.given.divides()) {
    PlanningProblem straight = problem;
    if (settings.shape == TrackShape::kAuto) straight.settings.shape = TrackShape::kStraight;
    return given_search(straight, prepared, context);
  }
  if (settings.guide.empty()) return relaid(problem, prepared, before, Offset::kBest, context);
  const SearchTask task(problem, prepared);
  return settings.shape == TrackShape::kStraight ? guided_search(task) : of_candidate(along_guide(task));
}

}  // namespace

Plan plan_edited(const Plan& before, const Field& field, const Machine& machine, const Objective& objective,
                 const PlanSettings& settings, int threads, const Progress& progress) {
  require_same_shape(before, field);
  const SearchContext context = SearchContext(threads, progress).without_bound();
  const PlanningProblem asked = edit_problem(field, machine, objective, settings);
  const PassesByBoundary passes = as_set(asked, passes_of(before));
  const PlanningProblem problem = problem_with(asked, passes);
  const std::optional<PreparedField> prepared = prepared_with(problem, passes);
  if (!prepared) throw no_room(problem);
  context.report();
  SearchResult found = laid_by_hand(problem, *prepared, before, context.uncounted());
  context.report();
  HeadlandTrial trial{passes, problem, *prepared, std::move(found), {}};
  trial.draft = drafted(SearchTask(trial.problem, trial.prepared), trial.found);
  const bool by_routes = settings.aim == Aim::kWholeCost && settings.turns == TurnPlanning::kRoute;
  Plan out = finished(by_routes ? or_with_worked_corners(std::move(trial)) : std::move(trial), context);
  out.proof = {};  // nothing was searched for
  if (context.cut_short()) mark_cut_short(out);
  return out;
}

}  // namespace tramline
