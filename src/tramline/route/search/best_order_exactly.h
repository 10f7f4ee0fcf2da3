#pragma once
// The cheapest order of a few lines.

#include <cstddef>

#include "tramline/route/search/end_costs.h"

namespace tramline::order {

/// More lines take too long.
inline constexpr std::size_t kMostLinesExactly = 11;

/// The cheapest of all tours, by dynamic programming over sets of lines (Held and Karp 1962). Among equals
/// always the same one. O(2^n·n²) steps and O(2^n·n) numbers. Precondition: at most
/// kMostLinesExactly lines.
Tour best_order_exactly(const EndCosts& costs);

}  // namespace tramline::order
