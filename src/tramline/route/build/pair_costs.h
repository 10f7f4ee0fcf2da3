#pragma once
// Costs of pairs of ends that were asked for.

#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include "tramline/route/search/end_costs.h"

namespace tramline {

/// A hash table of costs by two ends, in either order, of up to 2³² ends. Pairs lie in one array (open
/// addressing), because searches for an order ask for millions. O(1) on average.
class PairCosts {
 public:
  /// `expected`: so many pairs are likely to be asked for, and have a place from the beginning.
  explicit PairCosts(std::size_t expected = 0);

  /// The cost of the pair, `compute()` where it is not known.
  template <class Compute>
  double known_or(order::End a, order::End b, const Compute& compute) {
    const std::uint64_t pair = pair_of(a, b);
    std::size_t at = place_of(pair);
    if (entries_[at].pair == pair) return entries_[at].cost_s;
    const double cost_s = compute();
    if (2 * ++count_ > entries_.size()) {
      grow();
      at = place_of(pair);
    }
    entries_[at] = {pair, cost_s};
    return cost_s;
  }

  /// Where the cost is known, it is this from now on.
  void change(order::End a, order::End b, double cost_s);
  /// Keeps the places.
  void clear();

 private:
  static constexpr std::uint64_t kNone = std::numeric_limits<std::uint64_t>::max();
  struct Entry {
    std::uint64_t pair = kNone;
    double cost_s = 0;
  };
  static std::uint64_t pair_of(order::End a, order::End b) {
    return a < b ? std::uint64_t{a} << 32U | b : std::uint64_t{b} << 32U | a;
  }
  /// That of the pair, or the empty one where it belongs.
  std::size_t place_of(std::uint64_t pair) const {
    // Multiplied by the golden ratio (Knuth), of which the upper bits are mixed best.
    auto at = static_cast<std::size_t>((pair * 0x9E3779B97F4A7C15U) >> shift_);
    while (entries_[at].pair != pair && entries_[at].pair != kNone) at = (at + 1) & (entries_.size() - 1);
    return at;
  }
  void resize(unsigned bits);
  void grow();

  std::vector<Entry> entries_;
  std::size_t count_ = 0;
  unsigned shift_ = 0;  ///< what 64 bits have more than the number of a place
};

}  // namespace tramline
