#include "tramline/planner/headland_choice/trial_corners.h"

#include <cassert>
#include <utility>
#include <vector>

#include "tramline/headland/corners/worked_corners.h"
#include "tramline/headland/path_stretch.h"
#include "tramline/model/rate_values.h"
#include "tramline/planner/assembly/finished_plan.h"
#include "tramline/planner/assembly/whole_figures.h"
#include "tramline/planner/prepare_field.h"

namespace tramline {
namespace {

CornerPrices corner_prices(const Machine& machine) {
  const Rates rates = rates_of(machine);
  const SecondPrices second = second_prices(rates);
  const Turning& turning = machine.turning;
  CornerPrices out;
  out.missed_per_m2 = missed_price_per_m2(rates);
  out.doubled_per_m2 = overlap_price_per_m2(rates);
  out.in_and_out_per_m =
      second.at_work / turning.working_speed_mps + second.work_off / turning.reverse_speed_mps;
  out.per_stop = 2 * turning.gear_change_s * second.work_off + (turning.reverse ? 0 : rates.price_per_stop);
  return out;
}

/// A closed pass from where a leg of the route enters it, the way the leg leads.
Round as_entered(const Path& pass, const RouteLeg& leg) {
  const Pose start = leg.path.front().start;
  const double begin_m = nearest_along_m(pass, start.at);
  Path driven = stretch_of(pass, begin_m, begin_m + length(pass));
  const bool forward = dot(direction_at_start(driven.front()), start.heading.unit()) > 0;
  return {forward ? std::move(driven) : reversed(driven), true};
}

/// The closed passes of a plan as they are to be driven.
std::vector<Round> rounds_of(const Plan& plan, RoundPasses how) {
  const std::vector<HeadlandPass>& passes = plan.headland.passes;
  std::vector<Round> out(passes.size());
  if (how == RoundPasses::kOtherWay)
    for (std::size_t i = 0; i < passes.size(); ++i)
      if (is_closed(passes[i])) out[i].path = reversed(passes[i].path);
  if (how == RoundPasses::kAsBefore)
    for (const RouteLeg& leg : plan.route.legs)
      if (leg.pass && leg.work && is_closed(passes[*leg.pass]))
        out[*leg.pass] = as_entered(passes[*leg.pass].path, leg);
  return out;
}

double price(const HeadlandTrial& of) { return whole_cost(of.draft.plan).euros(); }

}  // namespace

bool may_cost_less(double expected, double least) {
  constexpr double kMayBeLess_share = 0.03;
  return expected < (1 + kMayBeLess_share) * least;
}

bool corners_pay(double euros_without, double euros_with) {
  constexpr double kLeastSaved_share = 0.01;
  return euros_with < (1 - kLeastSaved_share) * euros_without;
}

std::optional<ExpectedTrial> with_worked_corners(const HeadlandTrial& trial, const WorkOut& how) {
  assert(trial.draft.plan.route.planned());
  if (trial.problem.settings.route.corners == PassCorners::kRound) return std::nullopt;
  const Headland& headland = trial.prepared.headland;
  if (headland.passes.empty() || headland.construction != HeadlandConstruction::kDrivable)
    return std::nullopt;
  CornerPrices prices = corner_prices(trial.problem.machine);
  prices.in_and_out_per_m *= how.times_the_cost;
  prices.per_stop *= how.times_the_cost;
  const HeadlandTerms terms = headland_terms(trial.problem, headland.obstacle_passes);
  WorkedCorners worked = with_worked_corners(trial.problem.field, terms, headland, prices,
                                             rounds_of(trial.draft.plan, how.round));
  if (worked.saved <= 0) return std::nullopt;
  ExpectedTrial out{trial, worked.saved};
  out.trial.prepared.headland = std::move(worked.headland);
  return out;
}

HeadlandTrial or_with_worked_corners(HeadlandTrial trial) {
  std::optional<HeadlandTrial> best;
  for (const WorkOut& how : kWaysToWorkOut) {
    if (how.times_the_cost > 1 && best) break;
    std::optional<ExpectedTrial> worked = with_worked_corners(trial, how);
    if (!worked || (best && !may_cost_less(price(trial) - worked->saved, price(*best)))) continue;
    HeadlandTrial& other = worked->trial;
    other.draft = drafted(SearchTask(other.problem, other.prepared), other.found);
    if (corners_pay(price(trial), price(other)) && (!best || price(other) < price(*best)))
      best = std::move(other);
  }
  return best ? *std::move(best) : std::move(trial);
}

}  // namespace tramline
