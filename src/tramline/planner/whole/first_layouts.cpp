// What a comparison of routes begins with.

#include <algorithm>
#include <iterator>
#include <limits>
#include <utility>

#include "tramline/planner/for_each_index.h"
#include "tramline/planner/whole/route_floor.h"
#include "tramline/planner/whole/route_layouts.h"

namespace tramline {
namespace {

void append_found(std::vector<std::optional<LaidOut>> laid, std::vector<LaidOut>& out) {
  for (std::optional<LaidOut>& one : laid)
    if (one) out.push_back(std::move(*one));
}

std::vector<int> passes_asked(const PlanningProblem& problem) {
  const PlanSettings& settings = problem.settings;
  if (!settings.headland_edges.empty()) return settings.headland_edges;
  return std::vector<int>(problem.field.outer.size(), settings.headlands);
}

}  // namespace

std::vector<LaidOut> RouteLayouts::to_begin_with() {
  const bool by_turns = problem_.settings.headland_rule == HeadlandRule::kTurns;
  std::vector<std::vector<int>> round_obstacles{obstacle_passes_};
  const std::vector<int> none(obstacle_passes_.size(), 0);
  if (problem_.settings.obstacle_headland_rule == HeadlandRule::kTurns) {
    // Where tracks of the bare field go round an obstacle, those behind its headlands may end there.
    for (const std::vector<int>& other : {none, passes_round_all()})
      if (std::find(round_obstacles.begin(), round_obstacles.end(), other) == round_obstacles.end())
        round_obstacles.push_back(other);
  }
  std::vector<LaidOut> out;
  std::vector<Job> jobs;
  // Those behind which straight tracks may cost least: as many round obstacles as turns need, or none.
  std::optional<PassesByBoundary> for_curves;
  double least = std::numeric_limits<double>::infinity();
  for (const std::vector<int>& obstacles : round_obstacles) {
    if (!out.empty() && context_.has_to_end()) return out;
    const PassesByBoundary passes =
        by_turns ? all_round(least_passes_, obstacles) : PassesByBoundary{passes_asked(problem_), obstacles};
    if (!leave_other_land(passes)) continue;
    std::vector<LaidOut> found = searched(passes);
    for (Job& job : along_the_field(found)) jobs.push_back({job.kind, std::move(job.layout), passes});
    for (const Plan& layout : layouts_)
      if (follow_curves(layout.subfields)) jobs.push_back({Alternative::kSearched, layout, passes});
    if (!for_curves) for_curves = passes;
    for (const LaidOut& laid : found) {
      if (obstacles != none && obstacles != obstacle_passes_) continue;
      const double floor = route_floor(laid.trial.draft.plan, *laid.trial.prepared.turning_land);
      if (floor < least) for_curves = passes;
      least = std::min(least, floor);
    }
    std::move(found.begin(), found.end(), std::back_inserter(out));
  }
  if (by_turns && for_curves)
    for (LaidOut& laid : along_curves(*for_curves)) out.push_back(std::move(laid));
  if (!out.empty() && context_.has_to_end()) return out;
  std::vector<const Behind*> known(jobs.size(), nullptr);
  for (std::size_t i = 0; i < jobs.size(); ++i) known[i] = &behind(jobs[i].passes);
  std::vector<std::optional<LaidOut>> laid(jobs.size());
  for_each_index(laid.size(), context_,
                 [&](std::size_t i) { laid[i] = laid_out_on(*known[i], jobs[i].kind, jobs[i].layout); });
  append_found(std::move(laid), out);
  return out;
}

std::vector<LaidOut> RouteLayouts::behind_open_passes() {
  std::vector<LaidOut> out;
  if (problem_.settings.headland_rule != HeadlandRule::kTurns) return out;
  const std::vector<Job> along = along_the_field({});
  std::vector<std::pair<Alternative, const Plan*>> open;
  for (const Job& job : along) open.emplace_back(job.kind, &job.layout);
  const auto add = [&](const Plan& layout) {
    const bool known = std::any_of(open.begin(), open.end(),
                                   [&](const auto& one) { return same_directions(*one.second, layout); });
    if (!known && !layout.subfields.empty()) open.emplace_back(Alternative::kSearched, &layout);
  };
  for (const Plan& layout : layouts_) add(layout);
  const std::optional<Plan> usual = best_by_usual_prices(no_passes());
  if (usual) add(*usual);
  std::vector<std::optional<LaidOut>> laid(open.size());
  for_each_index(laid.size(), context_,
                 [&](std::size_t i) { laid[i] = where_it_ends(open[i].first, *open[i].second); });
  append_found(std::move(laid), out);
  return out;
}

}  // namespace tramline
