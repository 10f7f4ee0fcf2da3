#pragma once
// Decomposition of land into subfields, for one sweep direction.

#include "tramline/model/plan.h"

namespace tramline {

/// Versleijen §2.2.2 and §2.2.3: cells of the sweep, then the three merge phases in their order.
/// Settings used: decomposition_threshold, short_edge_m, merge_threshold, small_cell_m2, cell_direction.
std::vector<Subfield> decompose(const Region& plannable, Direction sweep, const PlanSettings& settings);

}  // namespace tramline
