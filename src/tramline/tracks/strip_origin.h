#pragma once
// Where the grid of tracks starts (S1.13).

#include "tramline/geometry/strip_grid.h"
#include "tramline/model/plan.h"

namespace tramline {

/// The grid of strips for a subfield: a strip line lies on the longest edge parallel to the driving
/// direction (within kParallelRadians), so that the first centre line runs w/2 from it and the others
/// follow every w on either side. Without a parallel edge the grid starts at the subfield's extreme
/// left, seen along the direction. Ties: the first such edge on the outer ring. O(n).
inline constexpr double kParallelRadians = 1e-6;
StripGrid strip_grid(const Subfield& subfield, double width_m);

}  // namespace tramline
