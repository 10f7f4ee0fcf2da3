#pragma once
// The costs of a tour that is closed by what comes before its start and after its finish.

#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

#include "tramline/route/search/end_costs.h"

namespace tramline::order {

/// Costs between the ends of the lines and of one line more, the outside: a tour enters it when it finishes
/// and leaves it when it starts. With it every tour is a ring, and driven backwards costs the same. Keeps
/// costs that were asked for lately, so one object serves one thread.
class ClosedCosts {
 public:
  explicit ClosedCosts(const EndCosts& costs);

  std::size_t lines() const { return lines_ + 1; }
  End finish() const { return 2 * lines_; }
  End start() const { return 2 * lines_ + 1; }

  double between(End a, End b) {
    if (a > b) std::swap(a, b);
    const std::uint64_t pair = std::uint64_t{a} << 32U | b;
    Known& known = known_[(a * kSpread + b) & (known_.size() - 1)];
    if (known.pair != pair) known = {pair, computed(a, b)};
    return known.cost;
  }

 private:
  /// Odd, so that the costs of one end to those near it lie apart from those of the next end.
  static constexpr std::size_t kSpread = 2654435761U;
  struct Known {
    std::uint64_t pair = std::numeric_limits<std::uint64_t>::max();
    double cost = 0;
  };
  double computed(End a, End b) const;

  const EndCosts& costs_;
  std::size_t lines_;
  std::vector<Known> known_;  ///< a power of two
};

}  // namespace tramline::order
