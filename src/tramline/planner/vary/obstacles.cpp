#include "tramline/planner/vary/obstacles.h"

#include <algorithm>
#include <cassert>
#include <vector>

#include "tramline/planner/vary/tracks.h"

namespace tramline {
namespace {

/// Whether so many passes round the obstacle cost less.
bool improves_with(RouteComparison& plans, RouteLayouts& layouts, std::size_t obstacle, int passes) {
  PassesByBoundary with = plans.best().passes;
  with.obstacles[obstacle] = passes;
  return !has_such(plans.plans(), plans.best_plan(), with) &&
         plans.improves(layouts.laid_out(Alternative::kSearched, plans.best_plan(), with));
}

/// The tracks that cost least behind so many passes, by the prices of the route and by the usual ones: where
/// obstacles have no headland others may than where they have one.
void search_behind(RouteComparison& plans, RouteLayouts& layouts, const std::vector<int>& obstacles) {
  PassesByBoundary with = plans.best().passes;
  with.obstacles = obstacles;
  if (with == plans.best().passes || plans.has_to_end()) return;
  if (!layouts.has_searched(with))
    for (LaidOut& laid : layouts.searched(with))
      if (!has_such(plans.plans(), laid.trial.draft.plan, with)) plans.improves(std::move(laid));
  vary_prices(plans, layouts, with);
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
    const int now = plans.best().passes.obstacles[i];
    improves_with(plans, layouts, i, now > 0 ? 0 : needed[i]);
    // A few turns in the corners beside an obstacle may have asked for many passes all along it.
    const int edges = *std::ranges::max_element(plans.best().passes.edges);
    int fewer = std::min(edges, plans.best().passes.obstacles[i] - 1);
    while (fewer > 0 && improves_with(plans, layouts, i, fewer)) --fewer;
  }
  if (count == 0) return;
  if (const auto none = layouts.none_round_obstacles()) search_behind(plans, layouts, *none);
  search_behind(plans, layouts, needed);
}

}  // namespace tramline
