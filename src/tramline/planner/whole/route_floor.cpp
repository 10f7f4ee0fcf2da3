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
  const Machine& machine = plan.machine;
  const Rates rates = rates_of(machine);
  const SecondPrices second = second_prices(rates);
  double work_m = 0;
  for (const TrackPiece& piece : plan.pieces) work_m += length(centre_line(piece));
  for (const HeadlandPass& pass : plan.headland.passes) work_m += length(pass.path);
  const double joins = static_cast<double>(plan.pieces.size()) -
                       static_cast<double>(plan.headland.passes.size()) -
                       static_cast<double>(plan.subfields.size());
  const double turning_m = std::max(0.0, joins) * std::numbers::pi * machine.radius_m;
  const int stops = machine.turning.reverse ? 0 : std::max(0, blind_ends(plan, turning_land) - 2);
  return second.at_work * work_m / machine.turning.working_speed_mps +
         second.work_off * turning_m / machine.turning.turning_speed_mps + rates.price_per_stop * stops +
         overlap_price_per_m2(rates) * plan.tally.overlap_m2 +
         missed_price_per_m2(rates) * plan.tally.uncovered_m2;
}

}  // namespace tramline
