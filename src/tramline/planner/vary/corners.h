#pragma once
// Plans whose headland passes are driven on into corners.

#include "tramline/planner/whole/route_comparison.h"

namespace tramline {

/// The best plans behind different headlands with the corners of their passes worked out, where that is
/// expected to cost less than the best one. Precondition: there is a plan.
void work_out_corners(RouteComparison& plans);

}  // namespace tramline
