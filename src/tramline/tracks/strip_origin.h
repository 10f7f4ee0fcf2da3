#pragma once
// The origin of the grid of tracks (Versleijen §2.2.1).

#include <vector>

#include "tramline/geometry/strip/strip_grid.h"
#include "tramline/model/plan.h"

namespace tramline {

/// The grids of strips to choose from for a subfield: a strip line lies on the longest edge parallel to the
/// driving direction, so that the first centre line runs w/2 from it and the others follow every w on either
/// side. Several edges of that length (up to kSameLength_share) give a grid each. Without a parallel edge a
/// strip line lies on the subfield's one or other extreme. Versleijen tries "to fit the paths so that the
/// uncovered area is minimised": the planner chooses the best of the grids. In increasing order across; never
/// empty. O(n).
std::vector<StripGrid> strip_grids(const Subfield& subfield, double width_m);

}  // namespace tramline
