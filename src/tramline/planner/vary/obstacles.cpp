#include "tramline/planner/vary/obstacles.h"

#include <algorithm>
#include <cassert>
#include <vector>

#include "tramline/planner/vary/tracks.h"

namespace tramline {
namespace {

int deepest_at_edges(const PassesByBoundary& passes) { return *std::ranges::max_element(passes.edges); }

/// Whether so many passes round the obstacle cost less.
bool improves_with(RouteComparison& plans, RouteLayouts& layouts, std::size_t obstacle, int passes) {
  PassesByBoundary with = plans.best().passes;
  with.obstacles[obstacle] = passes;
  return !has_such(plans.plans(), plans.best_plan(), with) &&
         plans.improves(layouts.laid_out(Alternative::kSearched, plans.best_plan(), with));
}

/// The obstacle gets a headland, or loses it. A few turns in the corners beside it may have asked for many
/// passes all along it: fewer are tried, no more than along the edges, as long as that costs less.
void vary_one(RouteComparison& plans, RouteLayouts& layouts, std::size_t obstacle, int needed) {
  const auto passes = [&] { return plans.best().passes.obstacles[obstacle]; };
  improves_with(plans, layouts, obstacle, passes() > 0 ? 0 : needed);
  int fewer = std::min(deepest_at_edges(plans.best().passes), (passes() > 0 ? passes() : needed) - 1);
  while (fewer > 0 && improves_with(plans, layouts, obstacle, fewer)) --fewer;
}

/// The tracks that cost least behind so many passes, by the prices of the route and by the usual ones, and
/// along curves: where obstacles have no headland others may than where they have one.
void search_behind(RouteComparison& plans, RouteLayouts& layouts, const std::vector<int>& obstacles) {
  PassesByBoundary with = plans.best().passes;
  with.obstacles = obstacles;
  if (!plans.goes_on_varying()) return;
  if (!layouts.has_searched(with))
    for (LaidOut& laid : layouts.searched(with)) plans.improves_on_such(std::move(laid));
  vary_prices(plans, layouts, with);
  vary_curves_behind(plans, layouts, with);
}

std::vector<int> one_round_each(std::vector<int> needed) {
  for (int& passes : needed) passes = std::min(passes, 1);
  return needed;
}

}  // namespace

void vary_obstacles(RouteComparison& plans, RouteLayouts& layouts) {
  assert(plans.has_best());
  if (plans.problem().settings.obstacle_headland_rule != HeadlandRule::kTurns) return;
  const std::vector<int> needed = layouts.passes_round_all();
  const auto count =
      static_cast<std::size_t>(std::ranges::count_if(needed, [](int passes) { return passes > 0; }));
  if (count > kFewObstacles) return;
  for (std::size_t i = 0; i < needed.size(); ++i)
    if (needed[i] > 0) vary_one(plans, layouts, i, needed[i]);
  if (count == 0) return;
  if (const auto none = layouts.none_round_obstacles()) search_behind(plans, layouts, *none);
  search_behind(plans, layouts, needed);
  search_behind(plans, layouts, one_round_each(needed));
}

}  // namespace tramline
