#include "tramline/planner/whole/route_floor.h"

#include <algorithm>
#include <numbers>
#include <vector>

#include "tramline/model/rate_values.h"
#include "tramline/planner/whole/track_prices.h"
#include "tramline/route/turning/stops.h"
#include "tramline/turns/turn_off.h"

namespace tramline {
namespace {

bool ends_blindly(const Path& path, const Plan& plan, const AllowedLand& land) {
  return !has_way_off(land, path.back().to, Heading::from_to({0, 0}, direction_at_end(path.back())),
                      plan.machine);
}

/// Ends of tracks and open passes that the machine can only back out of.
int blind_ends(const Plan& plan, const AllowedLand& land) {
  std::vector<TrackPiece> pieces = plan.pieces;
  int out = mark_stops(land, plan.machine, pieces);
  for (const HeadlandPass& pass : plan.headland.passes) {
    if (is_closed(pass)) continue;
    for (const Path& path : {pass.path, reversed(pass.path)}) out += ends_blindly(path, plan, land) ? 1 : 0;
  }
  return out;
}

}  // namespace

double route_floor(const Plan& plan, const AllowedLand& turning_land) {
  return floor_without_stops(plan, plan.headland.passes) + price_of_stops(plan, turning_land);
}

double price_of_stops(const Plan& plan, const AllowedLand& turning_land) {
  if (plan.machine.turning.reverse) return 0;
  return rates_of(plan.machine).price_per_stop * std::max(0, blind_ends(plan, turning_land) - 2);
}

double floor_without_stops(const Plan& plan, const std::vector<HeadlandPass>& passes) {
  const Machine& machine = plan.machine;
  const Rates rates = rates_of(machine);
  const SecondPrices second = second_prices(rates);
  double work_m = 0;
  for (const TrackPiece& piece : plan.pieces) work_m += length(centre_line(piece));
  for (const HeadlandPass& pass : passes) work_m += length(pass.path);
  const double joins = static_cast<double>(plan.pieces.size()) - static_cast<double>(passes.size()) -
                       static_cast<double>(plan.subfields.size());
  const double turning_m = std::max(0.0, joins) * std::numbers::pi * machine.radius_m;
  return second.at_work * work_m / machine.turning.working_speed_mps +
         second.work_off * turning_m / machine.turning.turning_speed_mps +
         overlap_price_per_m2(rates) * plan.tally.overlap_m2 +
         missed_price_per_m2(rates) * plan.tally.uncovered_m2;
}

}  // namespace tramline
