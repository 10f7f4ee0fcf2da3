#pragma once
// The area of a region in each cell.

#include <vector>

#include "tramline/geometry/polygon/region.h"
#include "tramline/model/cell_grid.h"

namespace tramline::coverage {

/// The area of the region in every cell, m², exact but for rounding (1e-9 of a cell counts as 0). O(cells and
/// the edges' parts in cells). Parts outside the grid are ignored. Precondition: oriented.
std::vector<double> area_in_cells(const Region& region, const CellGrid& grid);

}  // namespace tramline::coverage
