#include "tramline/planner/prepare_field.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "tramline/geometry/polygon/boolean.h"
#include "tramline/headland/body.h"
#include "tramline/headland/headland.h"
#include "tramline/headland/tolerances.h"
#include "tramline/planner/given/given_search.h"
#include "tramline/planner/given/land_parts.h"
#include "tramline/planner/given/take_off.h"
#include "tramline/planner/search/straight_search.h"
#include "tramline/route/turning/turning_land.h"

namespace tramline {
namespace {

bool has_headland(const std::vector<int>& passes, std::size_t obstacle) {
  return obstacle < passes.size() && passes[obstacle] > 0;
}

/// The field with only those obstacles for which `keep` is true; `indices` receives their indices.
template <class Keep>
Field with_obstacles(const Field& field, Keep keep, std::vector<std::size_t>& indices) {
  Field out = field;
  out.obstacles.clear();
  indices.clear();
  for (std::size_t i = 0; i < field.obstacles.size(); ++i) {
    if (!keep(i)) continue;
    out.obstacles.push_back(field.obstacles[i]);
    indices.push_back(i);
  }
  return out;
}

/// The body with passable land still in it, as ClassifiedGround::plannable has it.
Region body_with_passable(const Field& field, const HeadlandTerms& terms, const HeadlandAndBody& headland) {
  if (obstacle_shapes(field, ObstacleKind::kPassable).empty()) return headland.body;
  std::vector<std::size_t> indices;
  const auto solid = [&](std::size_t i) { return field.obstacles[i].kind == ObstacleKind::kObstacle; };
  const Field bare = with_obstacles(field, solid, indices);
  HeadlandTerms bare_terms = terms;
  bare_terms.obstacle_passes.clear();
  for (const std::size_t i : indices) bare_terms.obstacle_passes.push_back(terms.obstacle_passes[i]);
  return headland_of(bare, bare_terms).body;
}

/// The obstacles without a headland, sorted. Tracks do not reach the others, but detours have to keep off
/// them.
ClassifiedGround sorted_bare_obstacles(const PlanningProblem& problem, const std::vector<int>& passes) {
  const Field& field = problem.field;
  std::vector<std::size_t> indices;
  const auto bare = [&](std::size_t i) { return !has_headland(passes, i); };
  const Field met = with_obstacles(field, bare, indices);
  ClassifiedGround ground = classify_obstacles(met, problem.machine.width_m, problem.settings.clearance_m);
  for (Hazard& hazard : ground.hazards)
    for (std::size_t& obstacle : hazard.obstacles) obstacle = indices[obstacle];
  for (std::size_t i = 0; i < field.obstacles.size(); ++i)
    if (!bare(i)) ground.hazards.push_back({field.obstacles[i].shape, {i}, {}});
  return ground;
}

/// The land inside the headlands, of land on which the bare obstacles are sorted.
ClassifiedGround ground_behind(const PlanningProblem& problem, const HeadlandTerms& terms,
                               const HeadlandAndBody& headland, ClassifiedGround ground) {
  ground.body = headland.body;
  // Land given up belongs to the body. No swath enters the part of it that is headland either, but an end
  // there is not a stop.
  const Region in_headland = difference(ground.given_up, headland.body);
  if (!in_headland.empty()) {
    ground.beyond = unite(ground.beyond, in_headland);
    ground.hard = difference(ground.hard, in_headland);
  }
  ground.given_up = intersection(ground.given_up, headland.body);
  ground.plannable = intersection(ground.plannable, body_with_passable(problem.field, terms, headland));
  return ground;
}

bool clearance_takes_all(const PlanningProblem& problem, const ClassifiedGround& ground) {
  return problem.settings.clearance_m > 0 && area(ground.plannable) == 0 &&
         area(classify_obstacles(problem.field, problem.machine.width_m).plannable) > 0;
}

Region hard_field(const PlanningProblem& problem) {
  const PlanSettings& settings = problem.settings;
  const bool bare_edges = settings.headland_edges.empty() ? settings.headlands == 0
                                                          : passes_everywhere(settings.headland_edges) == 0;
  const bool hard = settings.boundary == EdgeKind::kHard && bare_edges;
  return hard ? Region{{problem.field.outer, {}}} : Region{};
}

/// The chords that round the corners of a body are no corners to divide it at.
double short_edge_m(const HeadlandTerms& terms) {
  int most = std::max(terms.field_passes, passes_anywhere(terms.edge_passes));
  for (const int passes : terms.obstacle_passes) most = std::max(most, passes);
  // The edges that passes leave run round the turns of the passes.
  const double widest_m = std::max(most * terms.width_m, terms.radius_m + 0.5 * terms.width_m);
  return 2 * std::sqrt(8 * widest_m * kBodySagitta);
}

/// Takes off the land that the user wants off, and divides the rest as the user wants.
void apply_given_land(const PlanningProblem& problem, PreparedField& field) {
  take_off_given(problem, field.ground, field.given);
  if (problem.settings.given.divides()) divide_as_given(problem, field.ground.plannable, field.given);
}

/// The field with its own passes and with these round its obstacles; nullopt where none has room. `bare`:
/// sorted_bare_obstacles().
std::optional<PreparedField> behind_headlands(const PlanningProblem& problem,
                                              const std::vector<int>& obstacle_passes,
                                              const ClassifiedGround& bare) {
  const HeadlandTerms terms = headland_terms(problem, obstacle_passes);
  HeadlandAndBody headland = headland_of(problem.field, terms);
  if (headland.body.empty() && headland.passes.empty()) return std::nullopt;
  PreparedField out;
  out.ground = ground_behind(problem, terms, headland, bare);
  apply_given_land(problem, out);
  out.body_m2 = area(out.ground.body);
  out.headland = std::move(headland);
  out.short_edge_m = std::max(problem.settings.short_edge_m, short_edge_m(terms));
  out.hard_field = hard_field(problem);
  out.clearance_takes_all = clearance_takes_all(problem, out.ground);
  out.turning_land =
      std::make_shared<AllowedLand>(turning_land(problem.field, problem.machine, problem.settings));
  return out;
}

std::optional<Preparation> only_prepared(std::optional<PreparedField> field) {
  if (!field) return std::nullopt;
  return Preparation{std::move(*field), std::nullopt};
}

/// The number of passes by obstacle; 0 for those that tracks go round.
std::vector<int> obstacle_passes(const PlanningProblem& problem, const std::vector<bool>& gone_round) {
  std::vector<int> out(problem.field.obstacles.size(), 0);
  for (std::size_t i = 0; i < out.size(); ++i)
    if (problem.field.obstacles[i].kind == ObstacleKind::kObstacle && !gone_round[i])
      out[i] = problem.settings.obstacle_headlands;
  return out;
}

/// The obstacles that some track reaches and all such tracks go round.
std::vector<bool> gone_round(const SearchTask& task, const Candidate& best) {
  std::vector<bool> met(task.field.obstacles.size(), false), cut = met;
  for (const Encounter& encounter : encounters_of(task, best))
    for (const std::size_t obstacle : encounter.obstacles) {
      met[obstacle] = true;
      if (encounter.chosen == Passing::kCut) cut[obstacle] = true;
    }
  for (std::size_t i = 0; i < met.size(); ++i) met[i] = met[i] && !cut[i];
  return met;
}

bool takes_off_land(const GivenLand& given) {
  return !given.left_out.empty() || !given.done.empty() || !given.elsewhere.empty();
}

/// The field with a headland round those obstacles that tracks do not go round in the best plan without
/// headlands.
std::optional<Preparation> prepared_by_search(const PlanningProblem& problem, const SearchContext& context) {
  const std::vector<int> no_passes(problem.field.obstacles.size(), 0);
  const bool field_has_passes = problem.settings.headlands > 0;
  const PreparedField bare = field_without_headlands(problem);
  const bool as_sorted = !takes_off_land(problem.settings.given);
  const ClassifiedGround sorted = as_sorted ? bare.ground : sorted_bare_obstacles(problem, no_passes);
  std::optional<PreparedField> before =
      field_has_passes ? behind_headlands(problem, no_passes, sorted) : bare;
  if (!before) return std::nullopt;
  const SearchTask task(problem, *before);
  SearchResult found = before->given.parts.empty() ? straight_search(task, context.uncounted())
                                                   : given_search(problem, *before, context.uncounted());
  context.report();
  const std::vector<int> passes = obstacle_passes(problem, gone_round(task, found.best));
  if (passes != no_passes)
    return only_prepared(behind_headlands(problem, passes, sorted_bare_obstacles(problem, passes)));
  if (field_has_passes) return Preparation{std::move(*before), std::move(found)};
  // The search used the bare field: the same land, except for the rounding of boolean operations and for the
  // corners that split it.
  return only_prepared(behind_headlands(problem, no_passes, sorted));
}

}  // namespace

HeadlandTerms headland_terms(const PlanningProblem& problem, const std::vector<int>& obstacle_passes) {
  return {problem.machine.width_m,
          problem.machine.radius_m,
          problem.settings.headlands,
          obstacle_passes,
          min_length_m(problem.machine),
          problem.settings.tracks == TrackConstruction::kPaper ? HeadlandConstruction::kPlain
                                                               : HeadlandConstruction::kDrivable,
          problem.settings.headland_edges,
          problem.settings.clearance_m};
}

PreparedField field_without_headlands(const PlanningProblem& problem) {
  PreparedField out;
  out.ground = classify_obstacles(problem.field, problem.machine.width_m, problem.settings.clearance_m);
  apply_given_land(problem, out);
  out.body_m2 = area(out.ground.body);
  out.short_edge_m = problem.settings.short_edge_m;
  out.hard_field = hard_field(problem);
  out.clearance_takes_all = clearance_takes_all(problem, out.ground);
  out.turning_land =
      std::make_shared<AllowedLand>(turning_land(problem.field, problem.machine, problem.settings));
  return out;
}

bool settings_decide_headlands(const PlanningProblem& problem) {
  const PlanSettings& settings = problem.settings;
  return settings.obstacle_headlands == 0 || settings.avoid == Avoidance::kCut ||
         settings.end_rule == EndRule::kCover || settings.shape != TrackShape::kStraight ||
         obstacle_shapes(problem.field, ObstacleKind::kObstacle).empty();
}

std::optional<Preparation> prepare_field(const PlanningProblem& problem, const SearchContext& context) {
  const PlanSettings& settings = problem.settings;
  if (settings.headlands == 0 && settings.obstacle_headlands == 0)
    return Preparation{field_without_headlands(problem), std::nullopt};
  if (!settings_decide_headlands(problem)) return prepared_by_search(problem, context);
  const std::vector<bool> none(problem.field.obstacles.size(), false);
  const std::vector<int> passes = obstacle_passes(problem, none);
  return only_prepared(behind_headlands(problem, passes, sorted_bare_obstacles(problem, passes)));
}

std::optional<PreparedField> field_behind(const PlanningProblem& problem,
                                          const std::vector<int>& obstacle_passes) {
  return behind_headlands(problem, obstacle_passes, sorted_bare_obstacles(problem, obstacle_passes));
}

Error no_room(const PlanningProblem& problem) {
  return bad_input(
      fmt::format("no swath {} m wide fits into the field '{}' of {:.0f} m²: use a narrower machine",
                  problem.machine.width_m, problem.field.id, area_m2(problem.field)));
}

}  // namespace tramline
