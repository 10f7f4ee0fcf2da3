#pragma once
// How much of each cell a region takes.

#include <vector>

#include "tramline/geometry/polygon/region.h"
#include "tramline/model/cell_grid.h"

namespace tramline::coverage {

/// The area of the region in every cell, m², exact but for rounding (1e-9 of a cell counts as none). O(cells
/// and the edges' parts in cells). What lies outside of the grid is left out. Precondition: oriented.
std::vector<double> area_in_cells(const Region& region, const CellGrid& grid);

}  // namespace tramline::coverage
