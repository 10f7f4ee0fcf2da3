#pragma once
// What legs of a route cost, and land that tracks leave, as whole_cost() counts them.

#include "tramline/model/machine.h"
#include "tramline/model/rate_values.h"
#include "tramline/model/route.h"

namespace tramline {

class LegPrices {
 public:
  /// The machine outlives it.
  explicit LegPrices(const Machine& machine);

  /// Its time, its stop and the room that it lacks, EUR; what is driven over is left out. O(1).
  double of(const RouteLeg& leg) const;
  /// EUR, of seconds with the work off, of land missed and of land worked again, m².
  double idle(double seconds) const { return second_.work_off * seconds; }
  double missed(double area_m2) const { return missed_price_per_m2(rates_) * area_m2; }
  double overlap(double area_m2) const { return overlap_price_per_m2(rates_) * area_m2; }

 private:
  const Machine& machine_;
  Rates rates_;
  SecondPrices second_;
};

}  // namespace tramline
