#include "tramline/route/search/best_order_exactly.h"

#include <bit>
#include <cassert>
#include <limits>
#include <vector>

namespace tramline::order {
namespace {

/// The cheapest tours over sets of lines, by the set and the end by which the last of them is left.
class SetsOfLines {
 public:
  explicit SetsOfLines(const EndCosts& costs)
      : ends_(2 * costs.lines()),
        costs_(costs),
        between_(ends_ * ends_),
        least_((std::size_t{1} << costs.lines()) * ends_, std::numeric_limits<double>::max()),
        before_(least_.size()) {
    for (End a = 0; a < ends_; ++a)
      for (End b = 0; b < ends_; ++b)
        if (line_of(a) != line_of(b)) between_[a * ends_ + b] = costs_.between(a, b);
  }

  Tour best() {
    for (End left = 0; left < ends_; ++left)
      least_[index(bit(left), left)] = costs_.at_start(other_end(left));
    const std::size_t all = (std::size_t{1} << (ends_ / 2)) - 1;
    for (std::size_t set = 1; set < all; ++set)
      for (End left = 0; left < ends_; ++left)
        if ((set & bit(left)) != 0) extend(set, left);
    End last = 0;
    for (End left = 1; left < ends_; ++left)
      if (whole(all, left) < whole(all, last)) last = left;
    return driven(all, last);
  }

 private:
  static std::size_t bit(End end) { return std::size_t{1} << line_of(end); }
  std::size_t index(std::size_t set, End left) const { return set * ends_ + left; }
  double whole(std::size_t all, End left) const { return least_[index(all, left)] + costs_.at_finish(left); }

  void extend(std::size_t set, End left) {
    for (End next = 0; next < ends_; ++next) {
      if ((set & bit(next)) != 0) continue;
      const double cost = least_[index(set, left)] + between_[left * ends_ + other_end(next)];
      const std::size_t to = index(set | bit(next), next);
      if (cost >= least_[to]) continue;
      least_[to] = cost;
      before_[to] = left;
    }
  }

  Tour driven(std::size_t set, End left) const {
    Tour out(static_cast<std::size_t>(std::popcount(set)));
    for (std::size_t i = out.size(); i-- > 0;) {
      out[i] = other_end(left);
      const End before = before_[index(set, left)];
      set ^= bit(left);
      left = before;
    }
    return out;
  }

  std::size_t ends_;
  const EndCosts& costs_;
  std::vector<double> between_;
  std::vector<double> least_;
  std::vector<End> before_;  ///< the end left before the last line
};

}  // namespace

Tour best_order_exactly(const EndCosts& costs) {
  assert(costs.lines() <= kMostLinesExactly);
  return costs.lines() == 0 ? Tour{} : SetsOfLines(costs).best();
}

}  // namespace tramline::order
