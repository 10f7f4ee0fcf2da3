#include "tramline/planner/vary/depth.h"

#include <algorithm>
#include <cstdlib>
#include <optional>
#include <utility>
#include <vector>

#include "tramline/planner/vary/tracks.h"
#include "tramline/planner/whole/plan_faults.h"

namespace tramline {
namespace {

/// So many passes more are tried one by one, and what lies between larger steps by halving them so often.
constexpr int kOneByOne = 6, kHalvings = 2;

/// One pass more or less that costs no more than this share above the best plan may lead to a better one.
constexpr double kHardly = 0.02;

/// Where a plan hardly works so many passes more than the least are tried, whether or not fewer cost more.
constexpr int kDeeper = 2;

class Depths {
 public:
  Depths(RouteComparison& plans, RouteLayouts& layouts, Narrow narrow)
      : plans_(plans), layouts_(layouts), narrow_(narrow == Narrow::kYes) {}

  void vary() {
    if (!plans_.has_best() || hardly_works(plans_.best_plan())) {
      try_all();
      return;
    }
    if (narrow_ && !all_round(plans_.best().passes)) {
      vary_from(layouts_.least_passes(), -1);
      return;
    }
    const int alone = layouts_.passes_alone();
    if (alone > 0 && improves_with_passes(alone)) {
      vary_from(alone, -1);
      return;
    }
    for (const int direction : {1, -1}) vary_from(layouts_.least_passes(), direction);
  }

 private:
  void try_all() {
    const std::vector<std::vector<int>> round_obstacles =
        obstacles_to_try(plans_.has_best() ? plans_.best().passes.obstacles : layouts_.passes_round_all());
    for (int passes = 0; passes <= layouts_.least_passes() + kDeeper; ++passes)
      for (const std::vector<int>& obstacles : round_obstacles) {
        if (plans_.has_best() && !plans_.goes_on_varying()) return;
        const PassesByBoundary round = layouts_.all_round(passes, obstacles);
        improves_with(round);
        if (narrow_) vary_prices(plans_, layouts_, round);
        if (passes == 0) try_without_passes(round);
      }
  }

  void try_without_passes(const PassesByBoundary& none) {
    for (LaidOut& laid : layouts_.along_sides(none)) plans_.improves(std::move(laid));
    vary_curves_behind(plans_, layouts_, none);
  }

  /// Deep passes may leave no room for headlands between them and an obstacle that tracks go round.
  std::vector<std::vector<int>> obstacles_to_try(std::vector<int> first) const {
    const std::optional<std::vector<int>> none = layouts_.none_round_obstacles();
    if (!none || *none == first) return {std::move(first)};
    return {std::move(first), *none};
  }

  /// By one pass at a time, and after some by twice as many each time: large land may be best worked by
  /// dozens of them. Then what lies between, roughly.
  void vary_from(int passes, int direction) {
    int step = direction;
    for (int steps = 1; improves_with_passes(passes + step) || improves_behind(passes, step); ++steps) {
      passes += step;
      if (steps >= kOneByOne) step *= 2;
    }
    for (int i = 0; i < kHalvings; ++i) {
      step /= 2;
      if (step != 0 && improves_with_passes(passes + step)) passes += step;
    }
  }

  /// Whether a step that hardly costs more leads to one that costs less: then the first is made up for.
  bool improves_behind(int& passes, int step) {
    if (std::abs(step) > 1 || !hardly_costs_more(passes + step)) return false;
    if (!improves_with_passes(passes + 2 * step)) return false;
    passes += step;
    return true;
  }

  bool hardly_costs_more(int passes) const {
    return std::ranges::any_of(plans_.plans(), [&](const ComparedPlan& plan) {
      return plan.price && !plan.only_told_of && all_round(plan.passes()) &&
             plan.passes().edges.front() == passes && *plan.price <= (1 + kHardly) * plans_.least_price();
    });
  }

  bool improves_with_passes(int passes) {
    if (passes <= 0 || !plans_.goes_on_varying()) return false;
    bool cheaper = false;
    for (const std::vector<int>& obstacles : obstacles_to_try(plans_.best().passes.obstacles))
      cheaper = improves_with(layouts_.all_round(passes, obstacles)) || cheaper;
    return cheaper;
  }

  bool improves_with(const PassesByBoundary& passes) {
    if (!layouts_.leave_other_land(passes)) return false;
    bool cheaper = false, best_comes_near = true;
    for (const std::size_t like : near_the_best(plans_.plans(), plans_.least_price())) {
      std::optional<LaidOut> laid =
          layouts_.laid_out(Alternative::kSearched, plans_.plans()[like].plan(), passes);
      if (!laid) continue;
      const std::size_t last = plans_.add(std::move(*laid));
      best_comes_near =
          plans_.least_expected(plans_.plans()[last]) <= (1 + kComesNear) * plans_.least_price();
      cheaper = plans_.improves(last) || cheaper;
    }
    if (!cheaper && !best_comes_near && !(narrow_ && hardly_works(plans_.best_plan()))) return false;
    for (LaidOut& laid : layouts_.searched(passes))
      cheaper = plans_.improves_on_such(std::move(laid)) || cheaper;
    for (LaidOut& laid : layouts_.along_sides(passes))
      cheaper = plans_.improves_on_such(std::move(laid)) || cheaper;
    return cheaper;
  }

  RouteComparison& plans_;
  RouteLayouts& layouts_;
  bool narrow_;
};

}  // namespace

void vary_depth(RouteComparison& plans, RouteLayouts& layouts, Narrow narrow) {
  if (plans.problem().settings.headland_rule == HeadlandRule::kTurns) Depths(plans, layouts, narrow).vary();
}

}  // namespace tramline
