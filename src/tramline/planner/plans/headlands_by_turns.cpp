#include "tramline/planner/plans/headlands_by_turns.h"

#include <cassert>
#include <optional>
#include <utility>

#include "tramline/geometry/error.h"
#include "tramline/geometry/polygon/bounding_rectangle.h"
#include "tramline/planner/assembly/finished_plan.h"
#include "tramline/planner/headland_choice/headland_trial.h"
#include "tramline/planner/headland_choice/headlands_for_turns.h"
#include "tramline/planner/headland_choice/relaid.h"
#include "tramline/planner/plans/cheapest_headlands.h"
#include "tramline/planner/prepare_field.h"
#include "tramline/planner/whole/shorter_ends.h"

namespace tramline {
namespace {

/// The layout that a search finds for the land behind the passes; nothing where no track fits there.
std::optional<Plan> directions_behind(PlanningProblem problem, int passes, const SearchContext& context) {
  problem.settings.headlands = passes;
  const std::optional<Preparation> behind = prepare_field(problem, context.uncounted());
  if (!behind || area(behind->field.ground.plannable) == 0) return std::nullopt;
  try {
    Plan out = searched_plan(problem, context.for_layout(), Explain::kNo).plan;
    if (!out.subfields.empty()) return out;
  } catch (const Error& error) {
    if (error.kind() != ErrorKind::kBadInput) throw;
  }
  return std::nullopt;
}

/// One direction, along the length of the field.
Plan directions_along(const PlanningProblem& problem) {
  Plan out;
  out.machine = problem.machine;
  out.subfields.push_back({{problem.field.outer, {}}, across_least_width(problem.field.outer)});
  return out;
}

/// The tracks over the whole field in the directions that are best behind the passes, or along its length
/// where there is no room behind any.
std::optional<Plan> layout_behind_passes(const PlanningProblem& bare, int passes,
                                         const SearchContext& context) {
  std::optional<Plan> directions;
  for (; !directions && passes > 0; --passes) directions = directions_behind(bare, passes, context);
  if (!directions) directions = directions_along(bare);
  std::optional<Preparation> prepared = prepare_field(bare, context.uncounted());
  if (!prepared) return std::nullopt;
  SearchResult found = relaid(bare, prepared->field, *directions, Offset::kBest, context.uncounted());
  if (!found.best.works()) return std::nullopt;
  found.directions_tried = directions->directions_tried;
  return finished_plan(SearchTask(bare, prepared->field), std::move(found), context.for_layout());
}

/// Nothing where a layout has no tracks. `by`: what decides; `deepening`: for headlands behind the layout.
std::optional<HeadlandTrial> best_trial(const PlanningProblem& problem, Decides by,
                                        const SearchContext& context, const SearchContext& deepening) {
  assert(headlands_follow_turns(problem.settings));
  const PlanningProblem bare = without_headlands_for_turns(problem);
  const Plan layout = searched_plan(bare, context.for_layout(), Explain::kNo).plan;
  if (layout.subfields.empty()) return std::nullopt;
  if (by == Decides::kCostOfTracks) return with_headlands_for_turns(problem, layout, deepening);
  return with_cheapest_headlands(problem, layout, context, deepening);
}

}  // namespace

bool headlands_follow_turns(const PlanSettings& settings) {
  return settings.headland_rule == HeadlandRule::kTurns ||
         settings.obstacle_headland_rule == HeadlandRule::kTurns;
}

PlanningProblem without_headlands_for_turns(PlanningProblem problem) {
  PlanSettings& settings = problem.settings;
  settings.turns = TurnPlanning::kNone;
  if (settings.headland_rule == HeadlandRule::kTurns) settings.headlands = 0;
  if (settings.obstacle_headland_rule == HeadlandRule::kTurns) settings.obstacle_headlands = 0;
  settings.headland_rule = settings.obstacle_headland_rule = HeadlandRule::kPasses;
  return problem;
}

ExplainedPlan planned_without_tracks(const PlanningProblem& problem, const SearchContext& context) {
  PlanningProblem as_asked =
      headlands_follow_turns(problem.settings) ? without_headlands_for_turns(problem) : problem;
  as_asked.settings.turns = problem.settings.turns;
  return {searched_plan(as_asked, context, Explain::kNo).plan, std::nullopt};
}

HeadlandTrial with_headlands_for_turns(const PlanningProblem& problem, const Plan& layout,
                                       const SearchContext& context) {
  const PlanningProblem bare = without_headlands_for_turns(problem);
  const auto behind_passes = [&](int passes) { return layout_behind_passes(bare, passes, context); };
  return trial_with_headlands_for_turns(problem, layout, behind_passes, context);
}

std::optional<HeadlandTrial> best_tracks_with_headlands_for_turns(const PlanningProblem& problem,
                                                                  const SearchContext& context) {
  return best_trial(problem, Decides::kCostOfTracks, context, context.without_bound());
}

ExplainedPlan planned_with_headlands_for_turns(const PlanningProblem& problem, Decides decides,
                                               const SearchContext& context) {
  std::optional<HeadlandTrial> best = best_trial(problem, decides, context, context);
  if (!best) return planned_without_tracks(problem, context);
  if (decides == Decides::kWholeCost) best = with_shorter_ends(*std::move(best));
  return {finished(*std::move(best), context), std::nullopt};
}

}  // namespace tramline
