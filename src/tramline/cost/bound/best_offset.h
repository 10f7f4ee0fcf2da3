#pragma once
// The cheapest offset of the grid for one direction.

#include "tramline/cost/bound/grid_bound.h"

namespace tramline {

/// A grid of the direction of its tally, and its cost as least_cost() counts it with tracks cut at
/// obstacles.
struct PricedOrigin {
  double origin_m = 0;
  double cost = 0;
};

/// λo·o + λu·u + λt·(pieces − crossings) + λs·stops.
double separate_cost(const Objective& objective, const Tally& tally);

/// Over all offsets in [0, w). Between the offsets at which a vertex meets a strip line, or the line at
/// which swaths end, the cost is quadratic where strips are plain (ALGORITHMS §0.5): each such interval is
/// looked at with its ends and the least of the parabola through three of its points, but for those whose
/// bound shows that they hold nothing better than `known`. O(n² log n) at worst, mostly O(n log n).
PricedOrigin best_offset(const GridTally& tally, const BoundTerms& terms, const PricedOrigin& known);

}  // namespace tramline
