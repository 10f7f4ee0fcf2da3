#pragma once
// The cheapest offset of the grid for one direction.

#include "tramline/cost/bound/grid_bound.h"

namespace tramline {

/// The offset of a grid in the direction of its tally, and the grid's cost as least_cost() counts it with
/// tracks cut at obstacles.
struct PricedOrigin {
  double origin_m = 0;
  double cost = 0;
};

/// The cost λo·o + λu·u + λt·(pieces − crossings) + λs·stops.
double separate_cost(const Objective& objective, const Tally& tally);

/// The cheapest offset of all in [0, w). Between the offsets at which a vertex meets a strip line, or the
/// line at which swaths end, the cost is quadratic where strips are plain: each such
/// interval is evaluated at its ends and at the minimum of the parabola through three of its points, except
/// where its bound shows that it holds nothing better than `known`. O(n² log n) at worst, mostly O(n log n).
/// `near_enough`: a share of the cost by which another offset may be cheaper than the one found; where it is
/// not 0 fewer intervals are looked at, and the share is no promise.
PricedOrigin best_offset(const GridTally& tally, const BoundTerms& terms, const PricedOrigin& known,
                         double near_enough = 0);

}  // namespace tramline
