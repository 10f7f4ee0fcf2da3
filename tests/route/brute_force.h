#pragma once
// All tours, one after the other.

#include <algorithm>
#include <limits>
#include <numeric>
#include <vector>

#include "tramline/route/search/end_costs.h"

namespace tramline::testing {

/// The least that any tour costs: all orders and, of each, all ends at which lines can be entered. Up to 8
/// lines.
inline double least_of_all_tours(const order::EndCosts& costs) {
  double least = std::numeric_limits<double>::max();
  std::vector<bool> driven(costs.lines(), false);
  const auto go_on = [&](const auto& self, order::End left, std::size_t count, double so_far) -> void {
    if (count == costs.lines()) {
      least = std::min(least, so_far + costs.at_finish(left));
      return;
    }
    for (order::End entered = 0; entered < 2 * costs.lines(); ++entered) {
      if (driven[entered / 2]) continue;
      driven[entered / 2] = true;
      self(self, entered ^ 1U, count + 1,
           so_far + (count == 0 ? costs.at_start(entered) : costs.between(left, entered)));
      driven[entered / 2] = false;
    }
  };
  go_on(go_on, 0, 0, 0);
  return least;
}

}  // namespace tramline::testing
