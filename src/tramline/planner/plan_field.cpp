#include "tramline/planner/plan_field.h"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <optional>
#include <utility>

#include "tramline/geometry/error.h"
#include "tramline/geometry/polygon/bounding_rectangle.h"
#include "tramline/planner/assembly/finished_plan.h"
#include "tramline/planner/assembly/whole_figures.h"
#include "tramline/planner/candidate/anchored_guide.h"
#include "tramline/planner/curved/along_guide.h"
#include "tramline/planner/curved/curved_candidate.h"
#include "tramline/planner/curved/curved_search.h"
#include "tramline/planner/curved/zhou_plan.h"
#include "tramline/planner/explain/explanation.h"
#include "tramline/planner/given/given_search.h"
#include "tramline/planner/headland_choice/headland_trial.h"
#include "tramline/planner/headland_choice/headlands_for_turns.h"
#include "tramline/planner/headland_choice/relaid.h"
#include "tramline/planner/headland_choice/room_beyond.h"
#include "tramline/planner/prepare_field.h"
#include "tramline/planner/search/straight_search.h"
#include "tramline/planner/warnings.h"
#include "tramline/planner/whole/cheapest_route.h"

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

enum class Explain { kNo, kYes };

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

/// The problem with tracks of this shape. Zhou's own construction is for curved ones.
PlanningProblem with_shape(PlanningProblem problem, TrackShape shape) {
  problem.settings.shape = shape;
  if (shape == TrackShape::kStraight) problem.settings.tracks = TrackConstruction::kParallel;
  return problem;
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

ExplainedPlan searched(const PlanningProblem& problem, const SearchContext& context, Explain explain) {
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

bool headlands_follow_turns(const PlanSettings& settings) {
  return settings.headland_rule == HeadlandRule::kTurns ||
         settings.obstacle_headland_rule == HeadlandRule::kTurns;
}

/// The problem without the headlands that are to follow from the turns of its plan, which has none.
PlanningProblem without_headlands_for_turns(PlanningProblem problem) {
  PlanSettings& settings = problem.settings;
  settings.turns = TurnPlanning::kNone;
  if (settings.headland_rule == HeadlandRule::kTurns) settings.headlands = 0;
  if (settings.obstacle_headland_rule == HeadlandRule::kTurns) settings.obstacle_headlands = 0;
  settings.headland_rule = settings.obstacle_headland_rule = HeadlandRule::kPasses;
  return problem;
}

/// The layout that a search finds for the land behind the passes; nothing where no track fits there.
std::optional<Plan> directions_behind(PlanningProblem problem, int passes, const SearchContext& context) {
  problem.settings.headlands = passes;
  const std::optional<Preparation> behind = prepare_field(problem, context.uncounted());
  if (!behind || area(behind->field.ground.plannable) == 0) return std::nullopt;
  try {
    Plan out = searched(problem, context.for_layout(), Explain::kNo).plan;
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

/// The plan where the headlands that were asked for leave no room for tracks: there is nothing for turns to
/// decide.
ExplainedPlan planned_without_tracks(const PlanningProblem& problem, const SearchContext& context) {
  PlanningProblem as_asked =
      headlands_follow_turns(problem.settings) ? without_headlands_for_turns(problem) : problem;
  as_asked.settings.turns = problem.settings.turns;
  return {searched(as_asked, context, Explain::kNo).plan, std::nullopt};
}

/// The plan with the headlands that the turns between the tracks of this layout need.
Plan with_headlands_for_turns(const PlanningProblem& problem, const Plan& layout,
                              const SearchContext& context) {
  const PlanningProblem bare = without_headlands_for_turns(problem);
  const auto behind_passes = [&](int passes) { return layout_behind_passes(bare, passes, context); };
  return plan_with_headlands_for_turns(problem, layout, behind_passes, context);
}

enum class Decides { kCostOfTracks, kWholeCost };

/// The plan, or the same layout behind passes all round the field where its route costs less: from one pass
/// on as long as more of them cost less.
Plan or_behind_passes_all_round(Plan plan, const PlanningProblem& problem, const Plan& layout,
                                const SearchContext& context) {
  constexpr int kMostPasses = 6;
  const auto price = [](const Plan& of) { return whole_cost(of).euros(); };
  PassesByBoundary passes{std::vector<int>(problem.field.outer.size(), 0), plan.headland.obstacle_passes};
  passes.obstacles.resize(problem.field.obstacles.size(), 0);
  double least = price(plan), before = kAnyCost;
  for (int all_round = 1; all_round <= kMostPasses && !context.has_to_end(); ++all_round) {
    passes.edges.assign(passes.edges.size(), all_round);
    std::optional<HeadlandTrial> trial =
        headland_trial(problem, layout, as_set(problem, passes), Offset::kOfLayout, context);
    if (!trial) break;
    Plan other = finished(*std::move(trial), TurnPlanning::kRoute, context);
    const double costs = price(other);
    if (costs < least) {
      least = costs;
      plan = std::move(other);
    }
    if (costs > before) break;
    before = costs;
  }
  return plan;
}

/// `decides`: between the headlands that the turns of the layout need, where tracks end, and others.
ExplainedPlan planned_with_headlands_for_turns(const PlanningProblem& problem, Decides decides,
                                               const SearchContext& context) {
  const PlanningProblem bare = without_headlands_for_turns(problem);
  const Plan layout = searched(bare, context.for_layout(), Explain::kNo).plan;
  if (layout.subfields.empty()) return planned_without_tracks(problem, context);
  Plan out = with_headlands_for_turns(problem, layout, context);
  if (decides == Decides::kWholeCost && problem.settings.headland_rule == HeadlandRule::kTurns)
    out = or_behind_passes_all_round(std::move(out), problem, layout, context.uncounted().without_bound());
  return {std::move(out), std::nullopt};
}

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
    return searched(with_shape(bare, shape), straight ? searching.without_sweep() : searching, Explain::kNo)
        .plan;
  };
  // Behind headlands that follow from turns, curves are looked for on the land that these leave.
  const bool by_turns = problem.settings.headland_rule == HeadlandRule::kTurns;
  const bool later = by_turns && bare.settings.shape == TrackShape::kAuto;
  std::vector<Plan> out{layout_of(later ? TrackShape::kStraight : bare.settings.shape)};
  if (follow_curves(out.front().subfields)) out.insert(out.begin(), layout_of(TrackShape::kStraight));
  return out;
}

/// Straight tracks by the usual prices of tracks, with the headlands that their turns need.
Plan by_usual_prices(PlanningProblem problem, const SearchContext& context) {
  const Objective prices = std::exchange(problem.objective, Objective{});
  const TrackShape shape = problem.settings.shape;
  Plan out = planned_with_headlands_for_turns(with_shape(std::move(problem), TrackShape::kStraight),
                                              Decides::kCostOfTracks, context)
                 .plan;
  out.objective = prices;
  out.cost = cost(prices, out.tally);
  out.settings.shape = shape;
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

ExplainedPlan planned_by_routes(const PlanningProblem& asked, const SearchContext& context, Explain explain) {
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
  const auto room_for_turns = [&](LayoutBy by) {
    if (no_track) throw Error(*no_track);
    const SearchContext deepening = comparing.uncounted().without_bound();
    if (!by_turns) return searched(problem, deepening, Explain::kNo).plan;
    if (by == LayoutBy::kTurns) return with_headlands_for_turns(problem, layouts.back(), deepening);
    return by_usual_prices(by == LayoutBy::kNoHeadland ? without_headlands_round(problem) : problem,
                           comparing.uncounted());
  };
  const Compare compare = explain == Explain::kYes ? Compare::kAll : Compare::kWhatMayWin;
  ComparedRoutes compared = cheapest_route(problem, layouts, room_for_turns, compare, comparing);
  return {std::move(compared.plan), std::nullopt, std::move(compared.all)};
}

ExplainedPlan planned(PlanningProblem problem, const SearchContext& context, Explain explain) {
  const bool whole =
      problem.settings.aim == Aim::kWholeCost && problem.settings.turns == TurnPlanning::kRoute;
  const Decides decides = whole ? Decides::kWholeCost : Decides::kCostOfTracks;
  if (!compares_routes(problem.settings)) problem.settings.aim = Aim::kCost;
  ExplainedPlan out;
  if (compares_routes(problem.settings))
    out = planned_by_routes(problem, context, explain);
  else if (headlands_follow_turns(problem.settings))
    out = planned_with_headlands_for_turns(problem, decides, context);
  else
    out = searched(problem, context, explain);
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
