#include "real/plans_along.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <vector>

#include "tramline/geometry/error.h"
#include "tramline/geometry/polygon/bounding_rectangle.h"
#include "tramline/geometry/strip/track_frame.h"
#include "tramline/planner/assembly/finished_plan.h"
#include "tramline/planner/headland_choice/headland_trial.h"
#include "tramline/planner/plan_field.h"
#include "tramline/planner/plans/cheapest_route.h"

namespace tramline::testing {
namespace {

constexpr int kMostPasses = 5;

Box box_along(const Field& field, Direction along) {
  const TrackFrame frame(along);
  Box out;
  for (const Point p : field.outer) out.extend(frame.to_track(p));
  return out;
}

void keep_cheaper(Plan plan, std::optional<Plan>& best) {
  if (!best || price_of(plan) < price_of(*best)) best = std::move(plan);
}

std::set<std::vector<int>> passes_round_obstacles(const Field& field, const Plan& like) {
  std::vector<int> as_there = like.headland.obstacle_passes;
  as_there.resize(field.obstacles.size(), 0);
  const int most = as_there.empty() ? 0 : std::max(1, *std::max_element(as_there.begin(), as_there.end()));
  return {as_there, std::vector<int>(as_there.size(), 0), std::vector<int>(as_there.size(), most)};
}

std::optional<Plan> along_line(const Field& field, const Machine& machine, Direction along) {
  const TrackFrame frame(along);
  const Box box = box_along(field, along);
  PlanSettings settings = settings_for(Aim::kWholeCost);
  settings.shape = TrackShape::kStraight;
  settings.guide = {frame.to_field({box.min_x, box.min_y}), frame.to_field({box.min_x, box.max_y})};
  try {
    return plan_field(field, machine, {}, settings, 1);
  } catch (const Error& error) {
    if (error.kind() != ErrorKind::kBadInput) throw;
  }
  return std::nullopt;
}

}  // namespace

PlanSettings settings_for(Aim aim) {
  PlanSettings out;
  out.headland_rule = out.obstacle_headland_rule = HeadlandRule::kTurns;
  out.boundary = EdgeKind::kHard;
  out.turns = TurnPlanning::kRoute;
  if (aim == Aim::kWholeCost) out.shape = TrackShape::kAuto;
  out.aim = aim;
  return out;
}

double price_of(const Plan& plan) { return whole_cost(plan).euros(); }

std::optional<Direction> main_direction(const Plan& plan) {
  double longest_m = -1;
  std::optional<Direction> out;
  for (const TrackPiece& piece : plan.pieces)
    if (length(piece) > longest_m && piece.start != piece.end) {
      longest_m = length(piece);
      out = Direction::along(piece.start, piece.end);
    }
  return out;
}

double elongation(const Field& field) {
  const Box box = box_along(field, across_least_width(field.outer));
  return box.height() / box.width();
}

std::optional<Plan> cheapest_along(const Field& field, const Machine& machine, const Plan& like,
                                   Direction along) {
  PlanningProblem problem =
      with_track_prices(planning_problem(field, machine, {}, settings_for(Aim::kWholeCost)));
  problem.settings.turns = TurnPlanning::kNone;
  problem.settings.shape = TrackShape::kStraight;
  Plan layout;
  layout.machine = problem.machine;
  layout.subfields.push_back({{problem.field.outer, {}}, along});
  const SearchContext context = SearchContext(1).without_bound();
  std::optional<Plan> best = along_line(field, machine, along);
  for (const std::vector<int>& obstacles : passes_round_obstacles(problem.field, like))
    for (int passes = 1; passes <= kMostPasses; ++passes) {
      const PassesByBoundary all_round{std::vector<int>(problem.field.outer.size(), passes), obstacles};
      std::optional<HeadlandTrial> trial =
          headland_trial(problem, layout, as_set(problem, all_round), Offset::kBest, context);
      if (!trial || !trial->found.best.works()) continue;
      trial->problem.settings.turns = TurnPlanning::kRoute;
      keep_cheaper(drafted(SearchTask(trial->problem, trial->prepared), trial->found).plan, best);
    }
  return best;
}

std::string figures_in_full(const Plan& plan) {
  const WholeCost cost = whole_cost(plan);
  constexpr double kHour_s = 3600;
  const auto direction = main_direction(plan);
  return fmt::format(
      "{:.2f} € {}: {:.3f} h (tracks {:.3f}, headland {:.3f}, turning {:.3f}, ways {:.3f}), overlap {:.0f} "
      "m², "
      "missed {:.0f} m², {} tracks, {} turns, {} stops, {} legs without room, {} passes{}, {} subfields",
      price_of(plan), direction ? fmt::format("at {:.1f}°", direction->degrees()) : "without tracks",
      cost.time_s() / kHour_s, cost.working_s / kHour_s, cost.headland_s / kHour_s, cost.turning_s / kHour_s,
      cost.transit_s / kHour_s, plan.tally.overlap_m2, plan.tally.uncovered_m2, plan.pieces.size(),
      plan.tally.turns, plan.tally.stops, legs_without_room(plan.route, plan.machine),
      plan.settings.headlands, plan.settings.headland_edges.empty() ? "" : " where tracks end",
      plan.subfields.size());
}

}  // namespace tramline::testing
