#include "tramline/planner/plan_field.h"

#include <fmt/format.h>

#include <cassert>
#include <limits>
#include <optional>
#include <utility>

#include "tramline/geometry/error.h"
#include "tramline/planner/best_curved.h"
#include "tramline/planner/curved_candidate.h"
#include "tramline/planner/finished_plan.h"
#include "tramline/planner/headlanded_task.h"
#include "tramline/planner/recursive_plan.h"
#include "tramline/planner/straight_search.h"
#include "tramline/planner/validate_request.h"
#include "tramline/planner/warnings.h"
#include "tramline/planner/whole_figures.h"

namespace tramline {
namespace {

Error no_curve(const Field& field, bool from_end_to_end) {
  if (from_end_to_end)
    return bad_input(
        fmt::format("no edge of field '{}' from one corner to another is a curve, and tracks as in the paper "
                    "need a line with two ends; give one with --guide, or leave --tracks paper out",
                    field.id));
  return bad_input(
      fmt::format("no edge of field '{}' is a curve that tracks could follow; give a line with "
                  "--guide, or leave --curved out",
                  field.id));
}

bool as_in_the_paper(const PlanSettings& settings) { return settings.tracks == TrackConstruction::kPaper; }

Candidate along_guide(const SearchTask& task) {
  const std::vector<Point>& guide = task.settings.guide;
  if (as_in_the_paper(task.settings)) return recursive_along(task, guide);
  const Reference reference = reference_along(task, guide, 0);
  std::vector<LinedSubfield> grounds;
  for (const Polygon& part : task.ground.plannable) {
    const auto subfield = subfield_along(task, part, reference);
    assert(subfield);  // Unmoved, the reference keeps the radii it was smoothed to.
    grounds.push_back({*subfield, 0});
  }
  return candidate_on(task, grounds);
}

std::optional<Candidate> along_best_edge(const SearchTask& task, const SearchContext& context) {
  if (as_in_the_paper(task.settings)) return recursive_along_best(task, context);
  if (std::optional<BestCurve> best = best_curved(task, context)) return std::move(best->candidate);
  return std::nullopt;
}

/// The best family of curved tracks, with what it was looked for on.
struct CurvedChoice {
  SearchTask task;
  Candidate candidate;
};

/// nullopt where no edge is curved, or headlands round all obstacles leave nothing.
std::optional<CurvedChoice> curved_choice(const Field& field, const Machine& machine,
                                          const Objective& objective, const PlanSettings& settings,
                                          const SearchContext& context) {
  try {
    SearchTask task = headlanded_task(field, machine, objective, settings, context);
    if (std::optional<Candidate> best = along_best_edge(task, context))
      return CurvedChoice{std::move(task), std::move(*best)};
  } catch (const Error& error) {
    if (error.kind() != ErrorKind::kBadInput) throw;
  }
  return std::nullopt;
}

enum class Explain { kNo, kYes };

/// Of a candidate that stands by itself.
Plan plan_of(const SearchTask& task, Candidate candidate, const SearchContext& context) {
  SearchResult found;
  found.best = std::move(candidate);
  found.directions_tried = 1;
  return finished_plan(task, std::move(found), context);
}

ExplainedPlan straight_plan(const SearchTask& task, SearchResult found, const SearchContext& context,
                            Explain explain) {
  ExplainedPlan out;
  require_tracks(task, found.best.avoided.tally);
  if (explain == Explain::kYes) out.why = explanation_of(task, found, context);
  out.plan = finished_plan(task, std::move(found), context);
  return out;
}

/// The straight plan, or the curved one where that costs less. Which obstacles have headlands is settled for
/// either by itself. The curved one comes first, being sooner found: what costs more is then soon told. To
/// explain a straight plan that has to be told as well.
ExplainedPlan cheaper_shape(const Field& field, const Machine& machine, const Objective& objective,
                            PlanSettings settings, const SearchContext& context, Explain explain) {
  settings.shape = TrackShape::kCurved;
  const std::optional<CurvedChoice> curved = curved_choice(field, machine, objective, settings, context);
  settings.shape = TrackShape::kStraight;
  settings.tracks = TrackConstruction::kParallel;
  SearchTask task = headlanded_task(field, machine, objective, settings, context);
  const double curved_cost =
      curved ? whole_cost(curved->task, curved->candidate) : std::numeric_limits<double>::infinity();
  if (explain == Explain::kNo) task.no_more_than = curved_cost - least_by_headland(task);
  SearchResult straight = straight_search(task, context);
  const bool stays_straight =
      !curved || (straight.best.works() && whole_cost(task, straight.best) <= curved_cost);
  ExplainedPlan out = stays_straight
                          ? straight_plan(task, std::move(straight), context, explain)
                          : ExplainedPlan{plan_of(curved->task, curved->candidate, context), std::nullopt};
  out.plan.settings.shape = TrackShape::kAuto;
  return out;
}

ExplainedPlan searched(const Field& field, const Machine& machine, const Objective& objective,
                       const PlanSettings& settings, const SearchContext& context, Explain explain) {
  if (as_in_the_paper(settings) && settings.shape == TrackShape::kStraight && settings.guide.empty())
    throw bad_input(
        "tracks as in the paper follow a line: with --tracks paper give --ab, --guide or --curved");
  if (as_in_the_paper(settings)) require_paper_ground(field, settings);
  if (settings.shape == TrackShape::kAuto)
    return cheaper_shape(field, machine, objective, settings, context, explain);
  const SearchTask task = headlanded_task(field, machine, objective, settings, context);
  if (settings.shape == TrackShape::kStraight && !as_in_the_paper(settings))
    return straight_plan(task, straight_search(task, context), context, explain);
  if (area(task.ground.plannable) == 0) return {finished_plan(task, SearchResult{}, context), std::nullopt};
  context.report();
  if (!settings.guide.empty()) return {plan_of(task, along_guide(task), context), std::nullopt};
  std::optional<Candidate> curved = along_best_edge(task, context);
  if (!curved) throw no_curve(field, as_in_the_paper(settings));
  return {plan_of(task, std::move(*curved), context), std::nullopt};
}

ExplainedPlan planned(const Field& field, const Machine& machine, const Objective& objective,
                      const PlanSettings& settings, const SearchContext& context, Explain explain) {
  validate_request(machine, objective, settings);
  ExplainedPlan out = searched(field, machine, objective, settings, context, explain);
  if (context.cut_short()) mark_cut_short(out.plan);
  return out;
}

}  // namespace

Plan plan_field(const Field& field, const Machine& machine, const Objective& objective,
                const PlanSettings& settings, int threads, const Progress& progress) {
  const SearchContext context(threads, progress);
  return planned(field, machine, objective, settings, context, Explain::kNo).plan;
}

ExplainedPlan plan_and_explain(const Field& field, const Machine& machine, const Objective& objective,
                               const PlanSettings& settings, int threads, const Progress& progress) {
  const SearchContext context(threads, progress);
  return planned(field, machine, objective, settings, context, Explain::kYes);
}

}  // namespace tramline
