#include "tramline/planner/vary/obstacles.h"

#include <algorithm>
#include <cassert>
#include <vector>

namespace tramline {

void vary_obstacles(RouteComparison& plans, RouteLayouts& layouts) {
  assert(plans.has_best());
  if (plans.problem().settings.obstacle_headland_rule != HeadlandRule::kTurns) return;
  const std::vector<int> needed = layouts.passes_round_all();
  const auto count =
      static_cast<std::size_t>(std::ranges::count_if(needed, [](int passes) { return passes > 0; }));
  if (count > kFewObstacles) return;
  for (std::size_t i = 0; i < needed.size(); ++i) {
    if (needed[i] == 0) continue;
    PassesByBoundary with = plans.best().passes;
    with.obstacles[i] = with.obstacles[i] > 0 ? 0 : needed[i];
    if (!has_such(plans.plans(), plans.best_plan(), with))
      plans.improves(layouts.laid_out(Alternative::kSearched, plans.best_plan(), with));
  }
}

}  // namespace tramline
