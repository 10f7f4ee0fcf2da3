#include "tramline/route/search/end_costs.h"

#include <cassert>

namespace tramline::order {

double EndCosts::at_start(End) const { return 0; }
double EndCosts::at_finish(End) const { return 0; }

double connection_s(const Tour& tour, const EndCosts& costs) {
  assert(tour.size() == costs.lines());
  if (tour.empty()) return 0;
  double sum = costs.at_start(tour.front()) + costs.at_finish(other_end(tour.back()));
  for (std::size_t i = 1; i < tour.size(); ++i) sum += costs.between(other_end(tour[i - 1]), tour[i]);
  return sum;
}

}  // namespace tramline::order
