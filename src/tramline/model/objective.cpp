#include "tramline/model/objective.h"

#include "tramline/model/tally.h"

namespace tramline {

double cost(const Objective& objective, const Tally& tally) {
  return objective.overlap * tally.overlap_m2 + objective.uncovered * tally.uncovered_m2 +
         objective.turn * tally.turns + objective.stop * tally.stops;
}

double cheapest_share(const Objective& objective) {
  const double sum = objective.overlap + objective.uncovered;
  return sum > 0 ? objective.overlap / sum : 0.5;
}

}  // namespace tramline
