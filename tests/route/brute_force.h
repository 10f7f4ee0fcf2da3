#pragma once
// All tours, one after the other.

#include <algorithm>
#include <limits>
#include <numeric>
#include <vector>

#include "tramline/route/certificate/connection_bounds.h"
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

/// The least that any route takes that joins all lines and rings in any order between its gates, by the
/// definition of ConnectionBounds. A few members.
inline double least_of_all_routes(const order::ConnectionBounds& bounds) {
  double least = std::numeric_limits<double>::max();
  const std::size_t lines = bounds.lines(), gates = bounds.gates();
  std::vector<bool> done(bounds.members(), false);
  // A route begins at the first gate, where there is one, and ends at the second.
  const auto go_on = [&](const auto& self, std::size_t left, std::size_t count, double so_far) -> void {
    if (count == lines + bounds.rings()) {
      least = std::min(least, so_far + (gates > 1 ? bounds.between(left, 2 * lines + 1) : 0));
      return;
    }
    for (std::size_t node = 0; node < bounds.nodes(); ++node) {
      const std::size_t member = bounds.member_of(node);
      if (bounds.is_gate(node) || done[member]) continue;
      done[member] = true;
      const double way = count == 0 && gates == 0 ? 0 : bounds.between(left, node);
      self(self, bounds.is_ring(node) ? node : node ^ 1U, count + 1, so_far + way);
      done[member] = false;
    }
  };
  go_on(go_on, 2 * lines, 0, 0);
  return least;
}

}  // namespace tramline::testing
