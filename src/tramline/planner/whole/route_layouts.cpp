#include "tramline/planner/whole/route_layouts.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numbers>
#include <utility>

#include "tramline/geometry/polygon/bounding_rectangle.h"
#include "tramline/headland/body.h"
#include "tramline/planner/curved/curved_search.h"
#include "tramline/planner/explain/longest_side.h"
#include "tramline/planner/headland_choice/foreseen_passes.h"
#include "tramline/planner/headland_choice/needed_passes.h"
#include "tramline/planner/prepare_field.h"
#include "tramline/planner/search/straight_search.h"
#include "tramline/planner/search/sweep_search.h"
#include "tramline/turns/turn_table.h"

namespace tramline {
namespace {

/// Directions nearer to one another are one.
constexpr double kSameDirection_deg = 1;
/// Passes beyond those that the deepest turn of the layout needs: round corners turns reach deeper.
constexpr int kMorePasses = 2;
/// Land is round where its area is no less than this share of the circle of as much perimeter: a hexagon has
/// 0.907, an ellipse half as long again as it is wide 0.92, a square 0.785.
constexpr double kRound = 0.9;

int least_passes_of(const Machine& machine) {
  const double depth_m = machine.radius_m + std::max(0.5 * machine.width_m, machine.turning.front_overhang_m);
  return std::max(1, passes_for(depth_m, machine.width_m));
}

/// A layout of tracks in one direction; where they lie is found with the headlands.
Plan layout_along(const PlanningProblem& problem, Direction direction) {
  Plan out;
  out.machine = problem.machine;
  out.subfields.push_back({{problem.field.outer, {}}, direction});
  out.directions_tried = 1;
  return out;
}

PlanningProblem with_straight_tracks(PlanningProblem problem) {
  problem.settings.shape = TrackShape::kStraight;
  return problem;
}

bool same_land(const PreparedField& a, const PreparedField& b) {
  return a.headland.passes.size() == b.headland.passes.size() && a.ground.plannable == b.ground.plannable &&
         a.ground.hard == b.ground.hard;
}

}  // namespace

bool passes_work_most(const PreparedField& prepared) {
  return prepared.headland.worked_m2 > area(prepared.ground.body);
}

bool all_in(const Plan& plan, Direction direction) {
  return std::all_of(plan.subfields.begin(), plan.subfields.end(), [&](const Subfield& subfield) {
    return subfield.reference.empty() &&
           angle_between(subfield.direction, direction).degrees() < kSameDirection_deg;
  });
}

bool same_directions(const Plan& a, const Plan& b) {
  if (a.subfields.size() != b.subfields.size()) return false;
  return std::all_of(a.subfields.begin(), a.subfields.end(), [&](const Subfield& of_a) {
    return std::any_of(b.subfields.begin(), b.subfields.end(), [&](const Subfield& of_b) {
      return of_a.reference.empty() && of_b.reference.empty() &&
             angle_between(of_a.direction, of_b.direction).degrees() < kSameDirection_deg;
    });
  });
}

RouteLayouts::RouteLayouts(const PlanningProblem& problem, const std::vector<Plan>& layouts,
                           const SearchContext& context)
    : problem_(problem),
      layouts_(layouts),
      context_(context.without_bound().without_sweep()),
      sweeping_(context.without_bound()),
      least_passes_(least_passes_of(problem.machine)) {
  problem_.settings.turns = TurnPlanning::kNone;
  obstacle_passes_ = layouts.front().headland.obstacle_passes;
  obstacle_passes_.resize(problem.field.obstacles.size(), 0);
  if (problem.settings.obstacle_headland_rule != HeadlandRule::kTurns || problem.field.obstacles.empty())
    return;
  first_open_ = where_tracks_end(layouts.front());
  obstacle_passes_ = first_open_->obstacles;
}

PassesByBoundary RouteLayouts::where_tracks_end(const Plan& layout) const {
  const PassesByBoundary needed = as_set(problem_, needed_passes(layout));
  return foreseen_passes(problem_, layout, needed, deepest(needed) + kMorePasses, context_);
}

std::optional<LaidOut> RouteLayouts::where_it_ends(Alternative kind, const Plan& layout) const {
  if (!layout.pieces.empty()) {
    const bool known = &layout == &layouts_.front() && first_open_;
    return laid_out_on(prepared_behind(known ? *first_open_ : where_tracks_end(layout)), kind, layout);
  }
  PlanningProblem bare = problem_;
  bare.settings.headland_rule = bare.settings.obstacle_headland_rule = HeadlandRule::kPasses;
  bare.settings.headlands = bare.settings.obstacle_headlands = 0;
  PreparedField prepared = field_without_headlands(bare);
  const auto laid =
      headland_trial_on(bare, std::move(prepared), layout, no_passes(), Offset::kBest, context_);
  if (!laid) return std::nullopt;
  const Plan& with_pieces = laid->draft.plan;
  return laid_out_on(prepared_behind(where_tracks_end(with_pieces)), kind, with_pieces);
}

PassesByBoundary RouteLayouts::all_round(int passes, const std::vector<int>& obstacles) const {
  return as_set(problem_, {std::vector<int>(problem_.field.outer.size(), passes), obstacles});
}

PassesByBoundary RouteLayouts::no_passes() const {
  return {std::vector<int>(problem_.field.outer.size(), 0),
          std::vector<int>(problem_.field.obstacles.size(), 0)};
}

RouteLayouts::Behind RouteLayouts::prepared_behind(const PassesByBoundary& passes) const {
  Behind out{passes, problem_with(problem_, passes), nullptr};
  std::optional<PreparedField> prepared = field_behind(out.problem, passes.obstacles);
  if (prepared && (area(prepared->ground.plannable) > 0 || passes_work_most(*prepared)))
    out.prepared = std::make_shared<const PreparedField>(std::move(*prepared));
  return out;
}

const RouteLayouts::Behind& RouteLayouts::behind(const PassesByBoundary& passes) {
  for (const std::unique_ptr<const Behind>& kept : kept_)
    if (kept->passes == passes) return *kept;
  kept_.push_back(std::make_unique<const Behind>(prepared_behind(passes)));
  return *kept_.back();
}

bool RouteLayouts::leave_other_land(const PassesByBoundary& passes) {
  const Behind& asked = behind(passes);
  return std::none_of(kept_.begin(), kept_.end(), [&](const std::unique_ptr<const Behind>& kept) {
    return kept->passes != passes && asked.prepared && kept->prepared &&
           same_land(*asked.prepared, *kept->prepared);
  });
}

std::optional<LaidOut> RouteLayouts::laid_out_on(const Behind& behind, Alternative kind,
                                                 const Plan& like) const {
  if (!behind.prepared || like.subfields.empty()) return std::nullopt;
  std::optional<HeadlandTrial> trial =
      headland_trial_on(behind.problem, *behind.prepared, like, behind.passes, Offset::kBest, context_);
  if (!trial) return std::nullopt;
  return LaidOut{kind, std::move(*trial)};
}

std::optional<LaidOut> RouteLayouts::laid_out(Alternative kind, const Plan& like,
                                              const PassesByBoundary& passes) {
  return laid_out_on(behind(passes), kind, like);
}

const SearchResult& RouteLayouts::straight_on(const Behind& behind) {
  assert(behind.prepared && area(behind.prepared->ground.plannable) > 0);
  const auto known =
      std::ranges::find(straight_, behind.passes, &std::pair<PassesByBoundary, SearchResult>::first);
  if (known != straight_.end()) return known->second;
  const PlanningProblem straight = with_straight_tracks(behind.problem);
  const SearchTask task(straight, *behind.prepared);
  return straight_.emplace_back(behind.passes, straight_search(task, context_.uncounted())).second;
}

std::vector<LaidOut> RouteLayouts::searched(const PassesByBoundary& passes) {
  searched_.push_back(passes);
  std::vector<LaidOut> out;
  const Behind& on = behind(passes);
  const PlanningProblem& problem = on.problem;
  const std::shared_ptr<const PreparedField>& prepared = on.prepared;
  if (!prepared) return out;
  if (area(prepared->ground.plannable) == 0) {
    PlanDraft draft = drafted(SearchTask(problem, *prepared), {});
    out.push_back({Alternative::kSearched, {passes, problem, *prepared, {}, std::move(draft)}});
    return out;
  }
  SearchResult found = straight_on(on);
  if (!found.best.works()) return out;
  const auto add = [&](Alternative kind, SearchResult result) {
    PlanDraft draft = drafted(SearchTask(problem, *prepared), result);
    out.push_back({kind, {passes, problem, *prepared, std::move(result), std::move(draft)}});
  };
  if (!found.undivided.empty()) {
    SearchResult undivided;
    const PlanningProblem straight = with_straight_tracks(problem);
    undivided.best = candidate_on(SearchTask(straight, *prepared), found.undivided);
    undivided.directions_tried = found.directions_tried;
    if (undivided.best.works()) add(Alternative::kUndivided, std::move(undivided));
  }
  add(Alternative::kSearched, std::move(found));
  return out;
}

bool RouteLayouts::has_searched(const PassesByBoundary& passes) const {
  return std::ranges::find(searched_, passes) != searched_.end();
}

bool RouteLayouts::looked_for_curves(const PassesByBoundary& passes) const {
  // Where the passes are given, curves behind them are among the layouts.
  return problem_.settings.headland_rule != HeadlandRule::kTurns ||
         std::ranges::find(curved_, passes) != curved_.end();
}

std::vector<LaidOut> RouteLayouts::along_curves(const PassesByBoundary& passes) {
  curved_.push_back(passes);
  const Behind& on = behind(passes);
  if (problem_.settings.shape != TrackShape::kAuto || !on.prepared) return {};
  if (area(on.prepared->ground.plannable) == 0) return {};
  const SearchTask task(on.problem, *on.prepared);
  std::vector<LaidOut> out;
  const auto add = [&](Candidate candidate) {
    SearchResult found;
    found.best = std::move(candidate);
    found.directions_tried = 1;
    PlanDraft draft = drafted(task, found);
    out.push_back(
        {Alternative::kSearched, {passes, on.problem, *on.prepared, std::move(found), std::move(draft)}});
  };
  const SearchContext searching = sweeping_.uncounted();
  std::optional<Candidate> along = along_best_edge(task, searching);
  if (along && along->works()) add(std::move(*along));
  SearchResult found = straight_on(on);
  const PlanningProblem straight = with_straight_tracks(on.problem);
  if (found.swept.empty()) found.swept = swept_candidates(SearchTask(straight, *on.prepared), searching);
  if (std::optional<Candidate> mixed = mixed_search(task, found, searching); mixed && mixed->works()) {
    add(std::move(*mixed));
    // Its subfields were priced by themselves; laid anew they know of one another.
    std::optional<LaidOut> anew = laid_out_on(on, Alternative::kSearched, out.back().trial.draft.plan);
    if (anew && anew->trial.draft.plan.cost < out.back().trial.draft.plan.cost) out.back() = std::move(*anew);
  }
  return out;
}

std::optional<Plan> RouteLayouts::best_by_usual_prices(const PassesByBoundary& passes) {
  const auto known =
      std::ranges::find(by_usual_prices_, passes, &std::pair<PassesByBoundary, std::optional<Plan>>::first);
  if (known != by_usual_prices_.end()) return known->second;
  return by_usual_prices_.emplace_back(passes, searched_by_usual_prices(passes)).second;
}

std::optional<Plan> RouteLayouts::searched_by_usual_prices(const PassesByBoundary& passes) {
  const Behind& on = behind(passes);
  if (!on.prepared || area(on.prepared->ground.plannable) == 0) return std::nullopt;
  PlanningProblem usual = with_straight_tracks(on.problem);
  usual.objective = Objective{};
  const SearchTask task(usual, *on.prepared);
  const SearchResult found = straight_search(task, context_.uncounted());
  if (!found.best.works()) return std::nullopt;
  return drafted(task, found).plan;
}

std::vector<RouteLayouts::Job> RouteLayouts::along_the_field(const std::vector<LaidOut>& known) const {
  std::vector<Job> out;
  const auto add = [&](Alternative kind, Direction direction) {
    const bool is_new =
        std::none_of(known.begin(), known.end(),
                     [&](const LaidOut& laid) { return all_in(laid.trial.draft.plan, direction); }) &&
        std::none_of(out.begin(), out.end(), [&](const Job& job) { return all_in(job.layout, direction); });
    if (is_new) out.push_back({kind, layout_along(problem_, direction), {}});
  };
  add(Alternative::kLongestSide, longest_side(problem_.field, problem_.machine.width_m));
  add(Alternative::kLength, across_least_width(problem_.field.outer));
  return out;
}

std::vector<LaidOut> RouteLayouts::along_sides(const PassesByBoundary& passes) {
  std::vector<LaidOut> out;
  const Behind& on = behind(passes);
  for (const Job& job : along_the_field({}))
    if (std::optional<LaidOut> laid = laid_out_on(on, job.kind, job.layout)) out.push_back(std::move(*laid));
  return out;
}

int RouteLayouts::passes_alone() const {
  if (!problem_.field.obstacles.empty()) return 0;
  const double area_m2 = std::abs(signed_area(problem_.field.outer));
  const double perimeter_m = perimeter(problem_.field.outer);
  if (4 * std::numbers::pi * area_m2 < kRound * perimeter_m * perimeter_m) return 0;
  // The radius of a circle, and of the circle in a polygon that has one; no convex land has a larger one.
  return passes_for(2 * area_m2 / perimeter_m, problem_.machine.width_m);
}

std::vector<int> RouteLayouts::passes_round_all() const {
  std::vector<int> out = obstacle_passes_;
  const std::vector<Obstacle>& obstacles = problem_.field.obstacles;
  if (obstacle_shapes(problem_.field, ObstacleKind::kObstacle).size() > kFewObstacles) return out;
  for (std::size_t i = 0; i < out.size(); ++i)
    if (obstacles[i].kind == ObstacleKind::kObstacle && out[i] == 0) out[i] = least_passes_;
  return out;
}

std::optional<std::vector<int>> RouteLayouts::none_round_obstacles() const {
  if (problem_.settings.obstacle_headland_rule != HeadlandRule::kTurns) return std::nullopt;
  if (obstacle_shapes(problem_.field, ObstacleKind::kObstacle).size() > kFewObstacles) return std::nullopt;
  return no_passes().obstacles;
}

}  // namespace tramline
