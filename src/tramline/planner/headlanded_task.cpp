#include "tramline/planner/headlanded_task.h"

#include <fmt/format.h>

#include <algorithm>

#include "tramline/geometry/boolean.h"
#include "tramline/geometry/error.h"
#include "tramline/headland/body.h"
#include "tramline/headland/headland.h"
#include "tramline/planner/straight_search.h"

namespace tramline {
namespace {

bool has_headland(const std::vector<int>& passes, std::size_t obstacle) {
  return obstacle < passes.size() && passes[obstacle] > 0;
}

/// Those obstacles that may stay when headlands are looked for, by index.
template <class Keep>
Field with_obstacles(const Field& field, Keep keep, std::vector<int>& indices) {
  Field out = field;
  out.obstacles.clear();
  indices.clear();
  for (std::size_t i = 0; i < field.obstacles.size(); ++i) {
    if (!keep(i)) continue;
    out.obstacles.push_back(field.obstacles[i]);
    indices.push_back(static_cast<int>(i));
  }
  return out;
}

/// The body with passable land still in it, as SortedGround::plannable has it.
Region body_with_passable(const Field& field, const HeadlandTerms& terms, const HeadlandAndBody& headland) {
  if (obstacle_shapes(field, ObstacleKind::kPassable).empty()) return headland.body;
  std::vector<int> indices;
  const auto solid = [&](std::size_t i) { return field.obstacles[i].kind == ObstacleKind::kObstacle; };
  const Field bare = with_obstacles(field, solid, indices);
  HeadlandTerms bare_terms = terms;
  bare_terms.obstacle_passes.clear();
  for (const int i : indices)
    bare_terms.obstacle_passes.push_back(terms.obstacle_passes[static_cast<std::size_t>(i)]);
  return headland_of(bare, bare_terms).body;
}

/// Obstacles with a headland do not meet tracks: they are sorted out, but detours have to keep off them.
SortedGround ground_behind(const SearchTask& task, const HeadlandTerms& terms,
                           const HeadlandAndBody& headland) {
  std::vector<int> indices;
  const auto bare = [&](std::size_t i) { return !has_headland(terms.obstacle_passes, i); };
  const Field met = with_obstacles(task.field, bare, indices);
  SortedGround ground = sort_obstacles(met, task.machine.width_m, task.settings.clearance_m);
  for (Hazard& hazard : ground.hazards)
    for (int& obstacle : hazard.obstacles) obstacle = indices[static_cast<std::size_t>(obstacle)];
  for (std::size_t i = 0; i < task.field.obstacles.size(); ++i)
    if (!bare(i)) ground.hazards.push_back({task.field.obstacles[i].shape, {static_cast<int>(i)}, {}});
  ground.body = headland.body;
  // Land given up is the body's affair; what of it is headland no swath enters either, but to end there is no
  // stop.
  const Region in_headland = difference(ground.given_up, headland.body);
  if (!in_headland.empty()) {
    ground.beyond = unite(ground.beyond, in_headland);
    ground.hard = difference(ground.hard, in_headland);
  }
  ground.given_up = intersection(ground.given_up, headland.body);
  ground.plannable = intersection(ground.plannable, body_with_passable(task.field, terms, headland));
  return ground;
}

Error no_room(const SearchTask& task) {
  return bad_input(
      fmt::format("no swath {} m wide fits into the field '{}' of {:.0f} m²: use a narrower machine",
                  task.machine.width_m, task.field.id, area_m2(task.field)));
}

/// The chords that round the corners of a body are no corners to divide it at.
double short_edge_m(const HeadlandTerms& terms) {
  int most = terms.field_passes;
  for (const int passes : terms.obstacle_passes) most = std::max(most, passes);
  // Edges of what passes leave lie about the turns of these.
  const double widest_m = std::max(most * terms.width_m, terms.radius_m + 0.5 * terms.width_m);
  return 2 * std::sqrt(8 * widest_m * kBodySagitta);
}

SearchTask task_with(const SearchTask& task, const std::vector<int>& obstacle_passes) {
  SearchTask out = task;
  const HeadlandTerms terms{task.machine.width_m, task.machine.radius_m, task.settings.headlands,
                            obstacle_passes, min_length_m(task.machine)};
  HeadlandAndBody headland = headland_of(task.field, terms);
  if (headland.body.empty() && headland.passes.empty()) throw no_room(task);
  if (task.settings.headlands > 0) out.settings.boundary = EdgeKind::kHard;
  out.short_edge_m = std::max(task.short_edge_m, short_edge_m(terms));
  out.ground = ground_behind(task, terms, headland);
  out.body_m2 = area(out.ground.body);
  out.headland = std::move(headland);
  return out;
}

bool may_go_round(const PlanSettings& settings) {
  return settings.avoid != Avoidance::kCut && settings.end_rule != EndRule::kCover &&
         settings.shape == TrackShape::kStraight;
}

/// The obstacles that some track meets and all go round.
std::vector<bool> gone_round(const SearchTask& task, const SearchContext& context) {
  std::vector<bool> met(task.field.obstacles.size(), false), cut = met;
  const SearchResult found = straight_search(task, context.uncounted());
  for (const Encounter& encounter : encounters_of(task, found.best))
    for (const int obstacle : encounter.obstacles) {
      met[static_cast<std::size_t>(obstacle)] = true;
      if (encounter.chosen == Passing::kCut) cut[static_cast<std::size_t>(obstacle)] = true;
    }
  for (std::size_t i = 0; i < met.size(); ++i) met[i] = met[i] && !cut[i];
  return met;
}

}  // namespace

SearchTask headlanded_task(const Field& field, const Machine& machine, const Objective& objective,
                           const PlanSettings& settings, const SearchContext& context) {
  SearchTask task = search_task(field, machine, objective, settings);
  if (settings.headlands == 0 && settings.obstacle_headlands == 0) return task;
  const bool any = !obstacle_shapes(field, ObstacleKind::kObstacle).empty();
  std::vector<int> passes(field.obstacles.size(), 0);
  if (settings.obstacle_headlands == 0 || !any) return task_with(task, passes);
  std::vector<bool> round(passes.size(), false);
  if (may_go_round(settings))
    round = gone_round(settings.headlands > 0 ? task_with(task, passes) : task, context);
  for (std::size_t i = 0; i < passes.size(); ++i)
    if (field.obstacles[i].kind == ObstacleKind::kObstacle && !round[i])
      passes[i] = settings.obstacle_headlands;
  return task_with(task, passes);
}

}  // namespace tramline
