#pragma once
// Distributes a slab's amount over cells.

#include <vector>

#include "tramline/coverage/dose/cell_parts.h"
#include "tramline/coverage/dose/slabs.h"

namespace tramline::coverage {

/// Appends the part of a slab's amount for each cell; the sum is slab.amount. The amount lies on the land of
/// the slab, with a density that varies from side to side as the slab says; where the machine hardly moved,
/// on a strip 1 cm deep. O(cells). Precondition: a positive amount.
void append_laid(const Slab& slab, double cell_m, std::vector<CellPart>& out);

}  // namespace tramline::coverage
