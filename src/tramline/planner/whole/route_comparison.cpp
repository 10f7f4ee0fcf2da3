#include "tramline/planner/whole/route_comparison.h"

#include <algorithm>
#include <cassert>
#include <limits>
#include <numeric>
#include <utility>

#include "tramline/planner/assembly/finished_plan.h"
#include "tramline/planner/whole/expected_route.h"
#include "tramline/planner/whole/route_alternative.h"

namespace tramline {
namespace {

/// Poses of roadmaps that searches for ways reach in about a minute. Of six slow real fields of up to 6 ha
/// the most took 624,000; a strip of 800 m full of passes 1.5 m wide took more than 1,900,000.
constexpr std::size_t kEnoughReached = 700'000;

}  // namespace

RouteComparison::RouteComparison(const PlanningProblem& problem, Compare compare,
                                 const SearchContext& context)
    : problem_(problem), compare_(compare), context_(context) {
  problem_.settings.turns = TurnPlanning::kNone;
}

const HeadlandTrial& RouteComparison::best() const {
  assert(best_);
  return plans_[*best_].laid.trial;
}

HeadlandTrial& RouteComparison::best_to_finish() {
  assert(best_);
  return plans_[*best_].laid.trial;
}

bool RouteComparison::took_enough() const { return reached_ > kEnoughReached; }

double RouteComparison::least_price() const {
  return best_ ? *plans_[*best_].price : std::numeric_limits<double>::infinity();
}

double RouteComparison::least_expected(const ComparedPlan& entry) const {
  return entry.floor + least_beyond_floor(plans_, entry);
}

std::size_t RouteComparison::add(LaidOut laid) { return add(compared_plan(std::move(laid))); }

std::size_t RouteComparison::add(ComparedPlan entry) {
  plans_.push_back(std::move(entry));
  return plans_.size() - 1;
}

void RouteComparison::take(ComparedPlan entry) { best_ = add(std::move(entry)); }

void RouteComparison::plan_route(ComparedPlan& entry, Patience patience) {
  context_.report();
  HeadlandTrial& trial = entry.laid.trial;
  trial.problem.settings.turns = TurnPlanning::kRoute;
  SearchTask task(trial.problem, trial.prepared);
  task.patience = patience;
  trial.draft = drafted(task, trial.found);
  // What order was taken is the planner's choice, as it was asked for.
  trial.problem.settings.route.order = trial.draft.plan.settings.route.order = problem_.settings.route.order;
  entry.price = whole_cost(trial.draft.plan).euros();
}

void RouteComparison::tell_of(const ComparedPlan& entry) {
  assert(entry.price);
  tell_of(alternative_of(entry.laid.kind, entry.plan()));
}

bool RouteComparison::improves(std::size_t i) {
  ComparedPlan& entry = plans_[i];
  if (entry.price || (best_ && context_.has_to_end())) return false;
  if (is_told_of(entry)) return false;
  const bool may_win = !best_ || least_expected(entry) + entry.lacks_room_like_others < least_price();
  if (!may_win && compare_ == Compare::kWhatMayWin) return false;
  plan_route(entry);
  if (may_win) reached_ += entry.laid.trial.draft.reached;
  tell_of(entry);
  entry.only_told_of = !may_win;
  return may_win && is_cheapest(i);
}

bool RouteComparison::is_cheapest(std::size_t i) {
  ComparedPlan& entry = plans_[i];
  // Other layouts may have room where this one has none.
  const double with_room = *entry.price - whole_cost(entry.plan()).without_room;
  entry.beyond_floor = std::max(0.0, with_room - entry.floor);
  if (*entry.price >= least_price()) return false;
  best_ = i;
  return true;
}

bool RouteComparison::improves_in_order(std::size_t i) {
  assert(plans_[i].price);
  ComparedPlan longer = plans_[i];
  plan_route(longer, Patience::kLong);
  if (*longer.price >= *plans_[i].price) return false;
  tell_of(longer);
  const bool cheapest = *longer.price < least_price();
  plans_[i] = std::move(longer);
  if (cheapest) best_ = i;
  return cheapest;
}

/// Whether the same tracks have their route already. In another order they are another plan.
bool RouteComparison::is_told_of(const ComparedPlan& entry) {
  if (entry.laid.kind == Alternative::kAdjacent) return false;
  const auto same = same_tracks_priced(plans_, entry);
  if (!same || plans_[*same].only_told_of) return false;
  if (plans_[*same].laid.kind != entry.laid.kind)
    tell_of(alternative_of(entry.laid.kind, plans_[*same].plan()));
  return true;
}

bool RouteComparison::improves(std::optional<LaidOut> laid) {
  return laid && improves(add(std::move(*laid)));
}

bool RouteComparison::improves_on_such(std::optional<LaidOut> laid) {
  if (!laid) return false;
  ComparedPlan plan = compared_plan(*std::move(laid));
  return !has_such_as_cheap(plans_, plan) && improves(add(std::move(plan)));
}

void RouteComparison::plan_routes(const Share& of_progress) {
  std::vector<std::size_t> order(plans_.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [this](std::size_t a, std::size_t b) { return plans_[a].floor < plans_[b].floor; });
  for (std::size_t done = 0; done < order.size(); ++done) {
    ComparedPlan& entry = plans_[order[done]];
    entry.lacks_room_like_others = room_lacked_by_others(plans_, entry);
    improves(order[done]);
    const double share = static_cast<double>(done + 1) / static_cast<double>(order.size());
    context_.reach(of_progress.from + (of_progress.to - of_progress.from) * share);
  }
}

}  // namespace tramline
