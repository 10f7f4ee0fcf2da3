#include "tramline/route/search/closed_costs.h"

#include <algorithm>
#include <bit>
#include <cassert>

namespace tramline::order {
namespace {

/// Kept costs for each end: those to the ends near it and to what they are connected with.
constexpr std::size_t kKeptOfEach = 32;

}  // namespace

ClosedCosts::ClosedCosts(const EndCosts& costs)
    : costs_(costs), lines_(costs.lines()), known_(std::bit_ceil(2 * kKeptOfEach * (lines_ + 1))) {}

double ClosedCosts::computed(End a, End b) const {
  assert(line_of(a) != line_of(b));
  if (b == start()) return costs_.at_start(a);
  if (b == finish()) return costs_.at_finish(a);
  return costs_.between(a, b);
}

}  // namespace tramline::order
