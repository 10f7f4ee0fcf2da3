#include "tramline/planner/whole/track_prices.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "tramline/model/rate_values.h"

namespace tramline {
namespace {

constexpr double kLeastShareOfMargin = 0.1;
/// About what it takes to back out of an end and drive round to the next track.
constexpr double kBackOut_s = 60;
constexpr double kWayToSubfield_s = 60;

double quickest_turn_s(const Machine& machine) {
  const double diameter_m = 2 * machine.radius_m;
  const double tracks = std::max(1.0, std::ceil(diameter_m / machine.width_m));
  const Turning& turning = machine.turning;
  const double length_m = std::numbers::pi * machine.radius_m + tracks * machine.width_m - diameter_m +
                          turning.lift_m + turning.lower_m;
  return length_m / turning.turning_speed_mps;
}

}  // namespace

Objective track_prices(const Machine& machine) {
  const Rates rates = rates_of(machine);
  const SecondPrices second = second_prices(rates);
  const double work = second.at_work / (machine.width_m * machine.turning.working_speed_mps);
  const double margin = missed_price_per_m2(rates);
  Objective out;
  out.overlap = overlap_price_per_m2(rates) + work;
  out.uncovered = std::max(margin - work, kLeastShareOfMargin * margin);
  out.turn = second.work_off * quickest_turn_s(machine);
  out.stop = rates.price_per_stop + second.work_off * kBackOut_s;
  out.subfield = second.work_off * kWayToSubfield_s;
  return out;
}

}  // namespace tramline
