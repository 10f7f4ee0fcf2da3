#include "tramline/planner/headland_choice/headland_trial.h"

#include <algorithm>
#include <utility>

#include "tramline/planner/prepare_field.h"

namespace tramline {

const LaidPiece& laid_piece(const HeadlandTrial& trial, std::size_t piece) {
  const LaidIndex index = trial.draft.driven.laid[piece];
  return trial.found.best.avoided.tracks[index.subfield].pieces[index.piece];
}

PassesByBoundary as_set(const PlanningProblem& problem, PassesByBoundary passes) {
  const PlanSettings& settings = problem.settings;
  if (settings.headland_rule == HeadlandRule::kPasses)
    std::fill(passes.edges.begin(), passes.edges.end(), settings.headlands);
  if (settings.obstacle_headland_rule == HeadlandRule::kPasses)
    for (std::size_t i = 0; i < passes.obstacles.size(); ++i)
      passes.obstacles[i] =
          problem.field.obstacles[i].kind == ObstacleKind::kObstacle ? settings.obstacle_headlands : 0;
  return passes;
}

PlanningProblem problem_with(const PlanningProblem& problem, const PassesByBoundary& passes) {
  PlanSettings settings = problem.settings;
  settings.headland_edges = passes.edges;
  PlanningProblem out = planning_problem(problem.field, problem.machine, problem.objective, settings);
  out.for_narrower = problem.for_narrower;
  return out;
}

std::optional<HeadlandTrial> headland_trial(const PlanningProblem& problem, const Plan& layout,
                                            const PassesByBoundary& passes, Offset offset,
                                            const SearchContext& context) {
  PlanningProblem with_passes = problem_with(problem, passes);
  std::optional<PreparedField> prepared = field_behind(with_passes, passes.obstacles);
  if (!prepared) return std::nullopt;
  return headland_trial_on(std::move(with_passes), std::move(*prepared), layout, passes, offset, context);
}

std::optional<HeadlandTrial> headland_trial_on(PlanningProblem problem, PreparedField prepared,
                                               const Plan& layout, const PassesByBoundary& passes,
                                               Offset offset, const SearchContext& context) {
  if (area(prepared.ground.plannable) == 0) return std::nullopt;
  SearchResult found = relaid(problem, prepared, layout, offset, context.uncounted());
  if (!found.best.works()) return std::nullopt;
  found.directions_tried = layout.directions_tried;
  PlanDraft draft = drafted(SearchTask(problem, prepared), found);
  return HeadlandTrial{passes, std::move(problem), std::move(prepared), std::move(found), std::move(draft)};
}

HeadlandTrial drafted_with(HeadlandTrial trial, TurnPlanning turns) {
  if (trial.problem.settings.turns == turns) return trial;
  trial.problem.settings.turns = turns;
  trial.draft = drafted(SearchTask(trial.problem, trial.prepared), trial.found);
  return trial;
}

Plan finished(HeadlandTrial trial, const SearchContext& context) {
  return finished(SearchTask(trial.problem, trial.prepared), std::move(trial.found), std::move(trial.draft),
                  context);
}

}  // namespace tramline
