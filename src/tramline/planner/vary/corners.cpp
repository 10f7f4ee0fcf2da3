#include "tramline/planner/vary/corners.h"

#include <algorithm>
#include <cassert>
#include <optional>
#include <utility>
#include <vector>

#include "tramline/planner/headland_choice/trial_corners.h"

namespace tramline {
namespace {

/// So many plans get their routes at the most.
constexpr std::size_t kMostPlans = 2;

struct Hope {
  double expected = 0;  ///< EUR
  std::size_t plan = 0;
  ExpectedTrial with_corners;
};

/// Plans with round corners as they may become with these worked out, the most hopeful first.
std::vector<Hope> hopes(const RouteComparison& plans, const std::vector<std::size_t>& round,
                        const WorkOut& how) {
  std::vector<Hope> out;
  for (const std::size_t i : round) {
    const ComparedPlan& entry = plans.plans()[i];
    if (std::optional<ExpectedTrial> worked = with_worked_corners(entry.laid.trial, how))
      out.push_back({*entry.price - worked->saved, i, *std::move(worked)});
  }
  std::ranges::stable_sort(out, {}, &Hope::expected);
  if (out.size() > kMostPlans) out.resize(kMostPlans);
  return out;
}

}  // namespace

void work_out_corners(RouteComparison& plans) {
  assert(plans.has_best());
  const double without = plans.least_price();
  const std::vector<std::size_t> round = best_of_each_depth(plans.plans(), without);
  for (const WorkOut& how : kWaysToWorkOut) {
    if (how.times_the_cost > 1 && plans.least_price() < without) return;
    for (Hope& hope : hopes(plans, round, how)) {
      if (plans.has_to_end()) return;
      if (!may_cost_less(hope.expected, plans.least_price())) break;
      ComparedPlan entry = plans.plans()[hope.plan];
      entry.laid = {Alternative::kWorkedCorners, std::move(hope.with_corners.trial)};
      plans.plan_route(entry);
      if (*entry.price >= plans.least_price() || !corners_pay(without, *entry.price)) continue;
      plans.tell_of(entry);
      plans.take(std::move(entry));
    }
  }
}

}  // namespace tramline
