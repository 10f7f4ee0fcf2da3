#include "tramline/model/objective.h"

#include "tramline/model/tally.h"

namespace tramline {

Objective weights_of(Scenario scenario) {
  constexpr double kAbove = 99999;
  switch (scenario) {
    case Scenario::kOverlap:
      return {kAbove, 1, 1, 0, 0};
    case Scenario::kUncovered:
      return {1, kAbove, 1, 0, 0};
    case Scenario::kTurns:
      return {1, 1, kAbove, 0, 0};
  }
  return {};
}

double cost(const Objective& objective, const Tally& tally) {
  return objective.overlap * tally.overlap_m2 + objective.uncovered * tally.uncovered_m2 +
         objective.turn * tally.turns + objective.stop * tally.stops +
         objective.subfield * further_subfields(tally);
}

double cheapest_share(const Objective& objective) {
  const double sum = objective.overlap + objective.uncovered;
  return sum > 0 ? objective.overlap / sum : 0.5;
}

}  // namespace tramline
