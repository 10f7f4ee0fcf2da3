#include "tramline/planner/vary/tracks.h"

#include <algorithm>
#include <cassert>
#include <limits>
#include <optional>
#include <utility>

#include "tramline/planner/whole/moved_grids.h"
#include "tramline/planner/whole/plan_faults.h"

namespace tramline {
namespace {

/// So many of the grids beside one get routes, and those beside a better one again, so often at the most.
constexpr std::size_t kRoutedBeside = 4;
constexpr int kTimesBeside = 3;

/// Of directions all round so many are drafted behind each depth of headland, and so many get routes, where
/// there are no more tracks.
constexpr std::size_t kPointed = 8, kRoutedAllRound = 8, kTracksAllRound = 32;

void vary_grid(RouteComparison& plans, std::size_t of) {
  const Plan& plan = plans.plans()[of].plan();
  if (plan.pieces.empty() || !has_few_tracks(plan)) return;
  for (LaidOut& laid : beside(plans.plans()[of].laid, kRoutedBeside, plans.context())) {
    if (!plans.goes_on_varying()) return;
    plans.improves(std::move(laid));
  }
}

/// A plan without a route, and what it is expected to cost, EUR: beyond its floor as much as another behind
/// the same passes.
struct Expected {
  double costs = 0;
  ComparedPlan plan;
};

/// Round obstacles there are as many passes as in the best plan.
void append_all_round(const RouteComparison& plans, const ComparedPlan& like, RouteLayouts& layouts,
                      std::vector<Expected>& out) {
  if (like.plan().pieces.empty() || like.plan().pieces.size() > kTracksAllRound) return;
  const PassesByBoundary passes{like.passes().edges, plans.best().passes.obstacles};
  const std::optional<LaidOut> on =
      passes == like.passes() ? like.laid : layouts.laid_out(Alternative::kSearched, like.plan(), passes);
  if (!on) return;
  const double beyond_floor = *like.price - like.floor;
  const double no_more_than = (1 + kComesNear) * plans.least_price();
  for (LaidOut& laid : all_round_the_compass(*on, kPointed, no_more_than - beyond_floor, plans.context())) {
    ComparedPlan plan = compared_plan(std::move(laid));
    const double costs = plan.floor + beyond_floor;
    if (costs <= no_more_than) out.push_back({costs, std::move(plan)});
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

void vary_curves(RouteComparison& plans, RouteLayouts& layouts) {
  assert(plans.has_best());
  std::vector<PassesByBoundary> behind{plans.best().passes};
  if (hardly_works(plans.best_plan()))
    for (const std::size_t of : best_of_each_depth(plans.plans(), plans.least_price()))
      behind.push_back(plans.plans()[of].passes());
  for (const PassesByBoundary& passes : behind) vary_curves_behind(plans, layouts, passes);
}

void vary_curves_behind(RouteComparison& plans, RouteLayouts& layouts, const PassesByBoundary& passes) {
  if (layouts.looked_for_curves(passes)) return;
  for (LaidOut& laid : layouts.along_curves(passes)) plans.improves(std::move(laid));
}

void vary_prices(RouteComparison& plans, RouteLayouts& layouts, const PassesByBoundary& passes) {
  if (const std::optional<Plan> usual = layouts.best_by_usual_prices(passes))
    plans.improves_on_such(layouts.laid_out(Alternative::kSearched, *usual, passes));
}

void vary_compass(RouteComparison& plans, RouteLayouts& layouts) {
  assert(plans.has_best());
  std::vector<Expected> all;
  for (const std::size_t of : best_of_each_depth(plans.plans(), plans.least_price()))
    append_all_round(plans, plans.plans()[of], layouts, all);
  std::ranges::stable_sort(all, {}, &Expected::costs);
  for (std::size_t i = 0; i < std::min(all.size(), kRoutedAllRound); ++i) {
    if (!plans.goes_on_varying()) return;
    plans.improves(plans.add(std::move(all[i].plan)));
  }
}

void vary_grids(RouteComparison& plans) {
  assert(plans.has_best());
  if (!plans.problem().field.obstacles.empty()) return;
  double before = std::numeric_limits<double>::infinity();
  for (int i = 0; i < kTimesBeside && plans.least_price() < before; ++i) {
    before = plans.least_price();
    for (const std::size_t of : about_as_good(plans.plans(), before)) vary_grid(plans, of);
  }
}

}  // namespace tramline
