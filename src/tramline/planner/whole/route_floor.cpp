#include "tramline/model/rate_values.h"
#include "tramline/planner/whole/route_floor.h"

#include <algorithm>
#include <numbers>
#include <vector>

#include "tramline/model/rate_values.h"
#include "tramline/planner/whole/track_prices.h"
#include "tramline/route/turning/stops.h"

namespace tramline {

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
  std::vector<TrackPiece> pieces = plan.pieces;
  const int stops = std::max(0, mark_stops(turning_land, machine, pieces) - 2);
  return rates.price_per_stop * stops + second.at_work * work_m / machine.turning.working_speed_mps +
         second.work_off * turning_m / machine.turning.turning_speed_mps + 
         overlap_price_per_m2(rates) * plan.tally.overlap_m2 +
         missed_price_per_m2(rates) * plan.tally.uncovered_m2;
}

}  // namespace tramline
