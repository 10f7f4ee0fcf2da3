#pragma once
// A slab's amount, laid on cells.

#include <vector>

#include "tramline/coverage/dose/cell_parts.h"
#include "tramline/coverage/dose/slabs.h"

namespace tramline::coverage {

/// Appends what each cell gets of a slab; the sum is slab.amount. It lies on the ground of the slab, denser
/// or thinner from one side to the other as the slab says; where the machine hardly moved, on a strip 1 cm
/// deep. O(cells). Precondition: a positive amount.
void append_laid(const Slab& slab, double cell_m, std::vector<CellPart>& out);

}  // namespace tramline::coverage
