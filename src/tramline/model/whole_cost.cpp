#include <cassert>

#include "tramline/model/plan.h"
#include "tramline/model/rate_values.h"

namespace tramline {
namespace {

constexpr double kSecondsPerHour = 3600;

void add_time(const RouteLeg& leg, WholeCost& out) {
  switch (leg.kind) {
    case LegKind::kWork:
      out.working_s += leg.time_s;
      return;
    case LegKind::kHeadland:
      out.headland_s += leg.time_s;
      return;
    case LegKind::kTurn:
    case LegKind::kBackOut:
      out.turning_s += leg.time_s;
      return;
    case LegKind::kTransit:
      out.transit_s += leg.time_s;
      return;
  }
}

}  // namespace

WholeCost whole_cost(const Plan& plan) {
  assert(plan.route.planned());
  const Rates rates = rates_of(plan.machine);
  WholeCost out;
  double fuel_s = 0;
  for (const RouteLeg& leg : plan.route.legs) {
    add_time(leg, out);
    if (leg.kind == LegKind::kBackOut) out.stops += rates.price_per_stop;
    if (lacks_room(leg, plan.machine)) out.without_room += kPriceWithoutRoom;
    fuel_s += leg.work ? leg.time_s : kIdleFuelShare * leg.time_s;
  }
  out.hours = rates.price_per_hour * out.time_s() / kSecondsPerHour;
  out.fuel_l = rates.fuel_l_per_h * fuel_s / kSecondsPerHour;
  out.fuel = rates.fuel_price * out.fuel_l;
  out.overlap = overlap_price_per_m2(rates) * plan.tally.overlap_m2;
  out.missed = missed_price_per_m2(rates) * plan.tally.uncovered_m2;
  out.driven_over = driven_over_price_per_m(rates) * plan.route.over_tracks_m;
  const double ideal_m2 = plan.machine.width_m * plan.machine.turning.working_speed_mps * out.time_s();
  if (ideal_m2 > 0) out.field_efficiency = (land_m2(plan) - plan.tally.uncovered_m2) / ideal_m2;
  return out;
}

WholeCost& WholeCost::operator+=(const WholeCost& other) {
  working_s += other.working_s;
  headland_s += other.headland_s;
  turning_s += other.turning_s;
  transit_s += other.transit_s;
  fuel_l += other.fuel_l;
  hours += other.hours;
  fuel += other.fuel;
  overlap += other.overlap;
  missed += other.missed;
  stops += other.stops;
  driven_over += other.driven_over;
  without_room += other.without_room;
  return *this;
}

}  // namespace tramline
