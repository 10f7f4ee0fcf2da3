#include "tramline/planner/plans/searched_plan.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <utility>

#include "tramline/geometry/error.h"
#include "tramline/planner/assembly/finished_plan.h"
#include "tramline/planner/assembly/whole_figures.h"
#include "tramline/planner/candidate/anchored_guide.h"
#include "tramline/planner/curved/along_guide.h"
#include "tramline/planner/curved/curved_candidate.h"
#include "tramline/planner/curved/curved_search.h"
#include "tramline/planner/curved/zhou_plan.h"
#include "tramline/planner/explain/explanation.h"
#include "tramline/planner/given/given_search.h"
#include "tramline/planner/prepare_field.h"
#include "tramline/planner/search/straight_search.h"
#include "tramline/planner/warnings.h"

namespace tramline {
namespace {

Error no_curve(const Field& field, bool from_end_to_end) {
  if (from_end_to_end)
    return bad_input(
        fmt::format("--tracks paper needs a line with two ends, and no edge of field '{}' that runs from one "
                    "corner to another is a curve; give a line with --guide, or leave out --tracks paper",
                    field.id));
  return bad_input(
      fmt::format("no edge of field '{}' is a curve that tracks could follow; give a line with "
                  "--guide, or leave --curved out",
                  field.id));
}

bool as_in_the_paper(const PlanSettings& settings) { return settings.tracks == TrackConstruction::kPaper; }

/// The search result of a single candidate.
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

/// The result of the straight search, moved out of `prepared` where preparing the field has made it already.
SearchResult found_on(const SearchTask& task, Preparation& prepared, const SearchContext& context,
                      double no_more_than = kAnyCost) {
  if (!prepared.found) return straight_search(task, context, no_more_than);
  const int directions = static_cast<int>(prepared.found->swept.size());
  context.count(directions, directions);
  return std::move(*prepared.found);
}

/// Straight and curved tracks on the same or on different land.
struct BothShapes {
  PlanningProblem curved, straight;
  std::optional<Preparation> for_curves, own{};
  bool shared = true;

  /// Which obstacles have headlands is settled for straight and curved tracks by themselves, unless the
  /// settings say so for both.
  BothShapes(const PlanningProblem& problem, const SearchContext& context)
      : curved(with_shape(problem, TrackShape::kCurved)),
        straight(with_shape(problem, TrackShape::kStraight)),
        for_curves(prepare_field(curved, context)),
        shared(settings_decide_headlands(straight)) {
    if (!shared) own = prepare_field(straight, context);
    if (!for_straight()) throw no_room(problem);
  }

  std::optional<Preparation>& for_straight() { return shared ? for_curves : own; }
};

/// The cheapest of a straight plan, one along one curve in each part of the ground, and one with curves in
/// some subfields of the straight one. Where a bound is to be proven curves are searched first, because they
/// are found sooner, so that more expensive straight plans are soon discarded; except to explain a straight
/// plan, which needs these too. Without a bound it is the other way round: most curves are abandoned early
/// where straight tracks are known to cost less.
ExplainedPlan cheapest_shape(const PlanningProblem& problem, const SearchContext& context, Explain explain) {
  BothShapes shapes(problem, context);
  const SearchTask task(shapes.straight, shapes.for_straight()->field);
  std::optional<Candidate> along_edge;
  double curved_cost = kAnyCost, straight_cost = kAnyCost;
  const auto find_curve = [&](double no_more_than) {
    if (!shapes.for_curves) return;
    const SearchTask curved(shapes.curved, shapes.for_curves->field);
    along_edge = along_best_edge(curved, context, no_more_than);
    if (along_edge) curved_cost = cost_with_headland(curved, *along_edge);
  };
  SearchResult found;
  const auto find_straight = [&](double no_more_than) {
    found = found_on(task, *shapes.for_straight(), context, no_more_than);
    if (found.best.works()) straight_cost = cost_with_headland(task, found.best);
  };
  if (context.wants_bound()) {
    find_curve(kAnyCost);
    find_straight(explain == Explain::kYes ? kAnyCost : curved_cost - least_by_headland(task));
  } else {
    find_straight(kAnyCost);
    find_curve(shapes.shared && found.best.works() ? found.best.cost() : kAnyCost);
  }
  std::optional<Candidate> mixed;
  if (!as_in_the_paper(problem.settings)) mixed = mixed_search(task, found, context);
  const bool is_mixed =
      mixed && costs_less(cost_with_headland(task, *mixed), std::min(straight_cost, curved_cost));

  ExplainedPlan out;
  if (is_mixed)
    out.plan = plan_of(task, std::move(*mixed), context);
  else if (along_edge && straight_cost > curved_cost)
    out.plan = plan_of(SearchTask(shapes.curved, shapes.for_curves->field), std::move(*along_edge), context);
  else
    out = straight_plan(task, std::move(found), context, explain);
  out.plan.settings.shape = TrackShape::kAuto;
  return out;
}

/// The plan where the user has divided the land.
ExplainedPlan divided_as_given(const PlanningProblem& problem, const SearchContext& context,
                               Explain explain) {
  std::optional<Preparation> prepared = prepare_field(problem, context);
  if (!prepared) throw no_room(problem);
  const SearchTask task(problem, prepared->field);
  if (area(task.ground.plannable) == 0) return {finished_plan(task, SearchResult{}, context), std::nullopt};
  SearchResult found =
      prepared->found ? std::move(*prepared->found) : given_search(problem, prepared->field, context);
  const bool curved = follow_curves(found.best.subfields);
  if (problem.settings.shape == TrackShape::kCurved && !curved) throw no_curve(problem.field, false);
  if (!curved) return straight_plan(task, std::move(found), context, explain);
  return {finished_plan(task, std::move(found), context), std::nullopt};
}

}  // namespace

PlanningProblem with_shape(PlanningProblem problem, TrackShape shape) {
  problem.settings.shape = shape;
  if (shape == TrackShape::kStraight) problem.settings.tracks = TrackConstruction::kParallel;
  return problem;
}

ExplainedPlan searched_plan(const PlanningProblem& problem, const SearchContext& context, Explain explain) {
  const PlanSettings& settings = problem.settings;
  if (as_in_the_paper(settings) && settings.shape == TrackShape::kStraight && settings.guide.empty())
    throw bad_input(
        "tracks as in the paper follow a line: with --tracks paper give --ab, --guide or --curved");
  if (as_in_the_paper(settings)) require_zhou_ground(problem.field, settings);
  if (settings.given.divides()) return divided_as_given(problem, context, explain);
  if (settings.shape == TrackShape::kAuto) return cheapest_shape(problem, context, explain);
  std::optional<Preparation> prepared = prepare_field(problem, context);
  if (!prepared) throw no_room(problem);
  const SearchTask task(problem, prepared->field);
  if (settings.shape == TrackShape::kStraight && !as_in_the_paper(settings))
    return straight_plan(task, found_on(task, *prepared, context), context, explain);
  if (area(task.ground.plannable) == 0) return {finished_plan(task, SearchResult{}, context), std::nullopt};
  context.report();
  if (!settings.guide.empty()) return {plan_of(task, along_guide(task), context), std::nullopt};
  std::optional<Candidate> curved = curved_search(task, context);
  if (!curved) throw no_curve(problem.field, as_in_the_paper(settings));
  return {plan_of(task, std::move(*curved), context), std::nullopt};
}

}  // namespace tramline
