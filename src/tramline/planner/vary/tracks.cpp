#include "tramline/planner/vary/tracks.h"

#include <algorithm>
#include <cassert>
#include <optional>
#include <utility>

#include "tramline/planner/whole/plan_faults.h"

namespace tramline {
namespace {

/// So many of the grids beside one are drafted, those of least cost of their tracks, and so many get routes.
constexpr std::size_t kDrafted = 12, kRouted = 2;

void vary_grid(RouteComparison& plans, std::size_t of) {
  const Plan& plan = plans.plans()[of].plan();
  if (plan.pieces.empty() || !has_few_tracks(plan)) return;
  ComparedPlans near;
  for (LaidOut& laid : beside(plans.plans()[of].laid, kDrafted))
    near.push_back(compared_plan(std::move(laid)));
  std::stable_sort(near.begin(), near.end(),
                   [](const ComparedPlan& a, const ComparedPlan& b) { return a.floor < b.floor; });
  for (std::size_t i = 0; i < std::min(near.size(), kRouted); ++i) {
    if (plans.has_to_end() || plans.least_expected(near[i]) >= plans.least_price()) return;
    plans.improves(plans.add(std::move(near[i])));
  }
}

}  // namespace

void vary_directions(RouteComparison& plans, RouteLayouts& layouts) {
  assert(plans.has_best());
  const PassesByBoundary passes = plans.best().passes;
  for (const std::size_t like : near_the_best(plans.plans(), plans.least_price())) {
    const Plan& plan = plans.plans()[like].plan();
    if (!has_such(plans.plans(), plan, passes))
      plans.improves(layouts.laid_out(Alternative::kSearched, plan, passes));
  }
}

void vary_prices(RouteComparison& plans, RouteLayouts& layouts, const PassesByBoundary& passes) {
  const std::optional<Plan> usual = layouts.best_by_usual_prices(passes);
  if (usual && !has_such(plans.plans(), *usual, passes))
    plans.improves(layouts.laid_out(Alternative::kSearched, *usual, passes));
}

void vary_grids(RouteComparison& plans) {
  assert(plans.has_best());
  if (!plans.problem().field.obstacles.empty()) return;
  for (const std::size_t i : about_as_good(plans.plans(), plans.least_price())) vary_grid(plans, i);
}

}  // namespace tramline
