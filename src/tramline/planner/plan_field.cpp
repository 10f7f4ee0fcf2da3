#include "tramline/planner/plan_field.h"

#include "tramline/planner/best_search.h"
#include "tramline/planner/finished_plan.h"
#include "tramline/planner/sweep_search.h"
#include "tramline/planner/validate_request.h"

namespace tramline {

SearchResult search_for(const SearchTask& task, int threads, const Progress& progress) {
  const auto search = task.settings.strategy == Strategy::kSweep ? sweep_search : best_search;
  return search(task, threads, progress);
}

Plan plan_field(const Field& field, const Machine& machine, const Objective& objective,
                const PlanSettings& settings, int threads, const Progress& progress) {
  validate_request(machine, objective, settings);
  const SearchTask task = search_task(field, machine, objective, settings);
  return finished_plan(task, search_for(task, threads, progress));
}

ExplainedPlan plan_and_explain(const Field& field, const Machine& machine, const Objective& objective,
                               const PlanSettings& settings, int threads, const Progress& progress) {
  validate_request(machine, objective, settings);
  const SearchTask task = search_task(field, machine, objective, settings);
  SearchResult found = search_for(task, threads, progress);
  require_tracks(task, found.best);
  Explanation why = explanation_of(task, found, threads);
  return {finished_plan(task, std::move(found)), std::move(why)};
}

}  // namespace tramline
