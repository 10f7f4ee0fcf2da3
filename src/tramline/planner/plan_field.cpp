#include "tramline/planner/plan_field.h"

#include <fmt/format.h>

#include <optional>

#include "tramline/geometry/error.h"
#include "tramline/planner/curved_plan.h"
#include "tramline/planner/finished_plan.h"
#include "tramline/planner/headlanded_task.h"
#include "tramline/planner/straight_search.h"
#include "tramline/planner/validate_request.h"

namespace tramline {
namespace {

Error no_curve(const Field& field) {
  return bad_input(
      fmt::format("no edge of field '{}' is a curve that tracks could follow; give a line with "
                  "--guide, or leave --curved out",
                  field.id));
}

}  // namespace

Plan plan_field(const Field& field, const Machine& machine, const Objective& objective,
                const PlanSettings& settings, int threads, const Progress& progress) {
  validate_request(machine, objective, settings);
  const SearchTask task = headlanded_task(field, machine, objective, settings, threads);
  if (settings.shape == TrackShape::kCurved && !settings.guide.empty())
    return finished_plan(task, curved_along(task, reference_along(task, settings.guide, 0)));
  if (settings.shape == TrackShape::kStraight)
    return finished_plan(task, straight_search(task, threads, progress));
  const std::optional<CurvedCandidate> curved = best_curved(task, threads);
  if (settings.shape == TrackShape::kCurved) {
    if (!curved) throw no_curve(field);
    return finished_plan(task, *curved);
  }
  Plan straight = finished_plan(task, straight_search(task, threads, progress));
  return curved && curved->cost < straight.cost ? finished_plan(task, *curved) : straight;
}

ExplainedPlan plan_and_explain(const Field& field, const Machine& machine, const Objective& objective,
                               const PlanSettings& settings, int threads, const Progress& progress) {
  validate_request(machine, objective, settings);
  const SearchTask task = headlanded_task(field, machine, objective, settings, threads);
  SearchResult found = straight_search(task, threads, progress);
  require_tracks(task, found.best.avoided.tally);
  Explanation why = explanation_of(task, found, threads);
  return {finished_plan(task, std::move(found)), std::move(why)};
}

}  // namespace tramline
