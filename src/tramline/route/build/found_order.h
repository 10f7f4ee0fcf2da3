#pragma once
// The order of lines of least cost that is found.

#include <vector>

#include "tramline/route/search/end_costs.h"
#include "tramline/route/search/neighbours.h"

namespace tramline::order {

/// How long a search goes on: as long as usual, or a part of that, from a tour that is good already.
enum class Effort { kWhole, kAgain };

/// Up to kMostLinesExactly lines the best order. Of more lines the best of a few tours that are shortened:
/// those given that cost least, and two greedy ones. Deterministic. Preconditions: there is a line;
/// neighbours are those of the ends of the lines, tours have every line once.
Tour found_order(const EndCosts& costs, const Neighbours& neighbours, const std::vector<Tour>& given,
                 Effort effort);

}  // namespace tramline::order
