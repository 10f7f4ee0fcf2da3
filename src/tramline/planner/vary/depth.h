#pragma once
// Plans with more or fewer headland passes.

#include "tramline/planner/whole/route_comparison.h"

namespace tramline {

/// Whether passes all round work most of the field.
enum class Narrow { kNo, kYes };

/// More or fewer passes all round the field, as long as that costs less; where the best plan hardly works, or
/// there is none, all depths to some beyond the least, and no headland; on narrow land where the best passes
/// lie along some edges only, fewer. The tracks of least cost behind them
/// are searched for where the best ones so far, laid anew, come near. Nothing where the passes are given.
void vary_depth(RouteComparison& plans, RouteLayouts& layouts, Narrow narrow);

}  // namespace tramline
