#include "tramline/planner/whole/leg_prices.h"

#include "tramline/model/plan.h"

namespace tramline {

LegPrices::LegPrices(const Machine& machine)
    : machine_(machine), rates_(rates_of(machine)), second_(second_prices(rates_)) {}

double LegPrices::of(const RouteLeg& leg) const {
  double out = (leg.work ? second_.at_work : second_.work_off) * leg.time_s;
  if (leg.kind == LegKind::kBackOut) out += rates_.price_per_stop;
  if (lacks_room(leg, machine_)) out += kPriceWithoutRoom;
  return out;
}

}  // namespace tramline
