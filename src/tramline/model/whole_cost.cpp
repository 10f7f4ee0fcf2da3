#include <cassert>

#include "tramline/model/plan.h"

namespace tramline {
namespace {

constexpr double kM2PerHa = 1e4, kSecondsPerHour = 3600;
/// With the work off an engine takes about so much of the fuel that it takes at work.
constexpr double kIdleFuelShare = 0.5;
/// Width of the land under the wheels of a machine, m: two wheel tracks of 0.6 m.
constexpr double kWheelTracks_m = 1.2;

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
    fuel_s += leg.work ? leg.time_s : kIdleFuelShare * leg.time_s;
  }
  out.hours = rates.price_per_hour * out.time_s() / kSecondsPerHour;
  out.fuel_l = rates.fuel_l_per_h * fuel_s / kSecondsPerHour;
  out.fuel = rates.fuel_price * out.fuel_l;
  out.overlap = rates.input_price_per_ha * plan.tally.overlap_m2 / kM2PerHa / rates.sections;
  out.missed = rates.margin_per_ha * plan.tally.uncovered_m2 / kM2PerHa;
  if (works_standing_crop(rates.operation))
    out.driven_over = rates.margin_per_ha * kWheelTracks_m * plan.route.over_tracks_m / kM2PerHa;
  const double ideal_m2 = plan.machine.width_m * plan.machine.turning.working_speed_mps * out.time_s();
  if (ideal_m2 > 0) out.field_efficiency = (land_m2(plan) - plan.tally.uncovered_m2) / ideal_m2;
  return out;
}

}  // namespace tramline
