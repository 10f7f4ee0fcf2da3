#include "tramline/check/file/compare_whole_cost.h"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <utility>

#include "tramline/check/rules/route/route_facts.h"
#include "tramline/model/rate_values.h"

namespace tramline::check {
namespace {

/// Sums of thousands of legs.
constexpr double kCostTolerance = 1e-6;
constexpr double kHour_s = 3600, kHectare_m2 = 1e4;
/// By docs/prices.md: fuel with the work off, of that at work; wheel tracks, m; and a leg without room, €.
constexpr double kWorkOffFuel = 0.5, kUnderWheels_m = 1.2, kLegWithoutRoom = 50;

/// What the legs of a route come to.
struct Driven {
  double work_s = 0, idle_s = 0;
  int stops = 0, without_room = 0;
};

Driven driven_by(const Plan& plan) {
  Driven out;
  for (const RouteLeg& leg : plan.route.legs) {
    (leg.work ? out.work_s : out.idle_s) += leg.time_s;
    if (leg.kind == LegKind::kBackOut) ++out.stops;
    if (cannot_be_driven(plan, leg)) ++out.without_room;
  }
  return out;
}

class CostComparison {
 public:
  CostComparison(const Plan& plan, const StatedCost& stated) : plan_(plan), stated_(stated) {}

  std::vector<Violation> run() {
    compare_rates();
    const Driven driven = driven_by(plan_);
    const Rates& rates = stated_.rates;
    const double hours = (driven.work_s + driven.idle_s) / kHour_s;
    const double litres = rates.fuel_l_per_h * (driven.work_s + kWorkOffFuel * driven.idle_s) / kHour_s;
    compare("hours", stated_.hours_h, hours);
    compare("litres", stated_.litres, litres);
    compare("euros", stated_.euros,
            hours * rates.price_per_hour + litres * rates.fuel_price + driven.stops * rates.price_per_stop +
                driven.without_room * kLegWithoutRoom + euros_of_land());
    compare_stop();
    return std::move(out_);
  }

 private:
  /// A stop counts its price in the bound of the route, or nothing where the route was to take little time.
  void compare_stop() {
    const Rates& rates = stated_.rates;
    const double second =
        (rates.price_per_hour + kWorkOffFuel * rates.fuel_l_per_h * rates.fuel_price) / kHour_s;
    const double counted_s = plan_.route.proof.stop_s;
    if (counted_s != 0)
      compare("s for each stop in its bound", counted_s,
              second > 0 ? std::min(kLongestStop_s, rates.price_per_stop / second) : 0);
  }

  double euros_of_land() const {
    const Rates& rates = stated_.rates;
    const double twice_ha = plan_.tally.overlap_m2 / kHectare_m2,
                 missed_ha = plan_.tally.uncovered_m2 / kHectare_m2;
    const double pressed_ha =
        works_standing_crop(rates.operation) ? plan_.route.over_tracks_m * kUnderWheels_m / kHectare_m2 : 0;
    return twice_ha * rates.input_price_per_ha / rates.sections +
           (missed_ha + pressed_ha) * rates.margin_per_ha;
  }

  /// Of the machine those are in the file that are not usual for its operation.
  void compare_rates() {
    const Rates& own = plan_.machine.rates;
    if (own.operation != stated_.rates.operation)
      add(fmt::format("the operation is {}, and that of the whole cost {}", name(own.operation),
                      name(stated_.rates.operation)),
          0);
    for (const RateNumber& number : kRateNumbers)
      if (own.*number.value >= 0 && own.*number.value != stated_.rates.*number.value)
        add(fmt::format("{} of the machine is {:g} {}, and that of the whole cost {:g}", number.key,
                        own.*number.value, number.unit, stated_.rates.*number.value),
            stated_.rates.*number.value - own.*number.value);
  }

  void compare(const char* what, double stated, double found) {
    // Written so that NaN is a violation.
    if (!(std::abs(stated - found) <= kCostTolerance * std::max(1.0, std::abs(found))))
      add(fmt::format("the route and its areas come to {:.6f} {}, not to {:.6f}", found, what, stated),
          stated - found);
  }

  void add(std::string what, double amount) {
    out_.push_back(
        {Rule::kWholeCost, std::move(what), plan_.route.legs.front().path.front().start.at, amount});
  }

  const Plan& plan_;
  const StatedCost& stated_;
  std::vector<Violation> out_;
};

}  // namespace

std::vector<Violation> compare_whole_cost(const Plan& plan, const StatedCost& stated) {
  assert(plan.route.planned());
  return CostComparison(plan, stated).run();
}

std::vector<std::string> rates_without_effect(const Plan& plan, const StatedCost& stated) {
  const Driven driven = driven_by(plan);
  const Rates& rates = stated.rates;
  const bool crop_pressed = works_standing_crop(rates.operation) && plan.route.over_tracks_m > 0;
  std::vector<std::string> out;
  const auto add = [&](double Rates::*value, bool has_effect) {
    if (has_effect || plan.machine.rates.*value >= 0) return;
    const auto number = std::find_if(kRateNumbers.begin(), kRateNumbers.end(),
                                     [&](const RateNumber& one) { return one.value == value; });
    out.push_back(fmt::format("whole_cost.rates.{}", number->key));
  };
  add(&Rates::fuel_price, stated.litres > 0);
  add(&Rates::sections, plan.tally.overlap_m2 > 0 && rates.input_price_per_ha > 0);
  add(&Rates::input_price_per_ha, plan.tally.overlap_m2 > 0);
  add(&Rates::margin_per_ha, plan.tally.uncovered_m2 > 0 || crop_pressed);
  add(&Rates::price_per_stop, driven.stops > 0 || plan.route.proof.stop_s > 0);
  return out;
}

}  // namespace tramline::check
