#include "tramline/planner/vary/obstacles.h"

#include <algorithm>
#include <cassert>
#include <vector>

namespace tramline {
namespace {

void vary_one(RouteComparison& plans, RouteLayouts& layouts, std::size_t obstacle, int passes) {
  PassesByBoundary with = plans.best().passes;
  if (with.obstacles[obstacle] == passes) return;
  with.obstacles[obstacle] = passes;
  if (!has_such(plans.plans(), plans.best_plan(), with))
    plans.improves(layouts.laid_out(Alternative::kSearched, plans.best_plan(), with));
}

}  // namespace

void vary_obstacles(RouteComparison& plans, RouteLayouts& layouts) {
  assert(plans.has_best());
  if (plans.problem().settings.obstacle_headland_rule != HeadlandRule::kTurns) return;
  const std::vector<int> needed = layouts.passes_round_all();
  const auto count =
      static_cast<std::size_t>(std::ranges::count_if(needed, [](int passes) { return passes > 0; }));
  if (count > kFewObstacles) return;
  for (std::size_t i = 0; i < needed.size(); ++i) {
    if (needed[i] == 0) continue;
    vary_one(plans, layouts, i, plans.best().passes.obstacles[i] > 0 ? 0 : needed[i]);
    // A few turns in the corners beside an obstacle may have asked for many passes all along it.
    const int edges = *std::ranges::max_element(plans.best().passes.edges);
    if (edges > 0 && plans.best().passes.obstacles[i] > edges) vary_one(plans, layouts, i, edges);
  }
}

}  // namespace tramline
