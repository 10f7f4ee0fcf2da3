#pragma once
// The land of a strip that detours may work.

#include "tramline/cost/bound/boundary_windows.h"
#include "tramline/cost/bound/row_cost_bound.h"
#include "tramline/geometry/interval.h"

namespace tramline {

/// Whether any of the zones reaches between these coordinates along.
bool reaches_between(const Intervals& zones, double low, double high);

/// The rows of `zones`, where detours may work, with all of the windows that these reach into; columns move
/// along by shear_m. Sorted. O(windows · zones).
Intervals pooled_rows(const std::vector<BoundaryWindow>& windows, const Intervals& zones, double shear_m);

/// Subtracts λo times the most land that may lie in the pooled rows of the strip. O(p log p).
void subtract_land(const std::vector<BoundaryWindow>& windows, const Intervals& zones,
                   const Intervals& pooled, const RowBoundTerms& moving, RowBounds& from);

}  // namespace tramline
