#pragma once
// The drift of spray by the wind.

#include <vector>

#include "tramline/coverage/dose/dose_settings.h"
#include "tramline/model/cell_grid.h"
#include "tramline/model/dose_map.h"

namespace tramline::coverage {

DoseDrift drift_of(const WindSettings& wind);

/// The range of offsets by which the wind moves amounts, m: the grid has to extend that far beyond the
/// applied amounts.
Box reach(const DoseDrift& drift, double cell_m);

/// The drifting share of `laid` by cell: the amount of each cell, taken as even over the cell, is moved and
/// spread over the cells it reaches. The sum is drift.share times that of `laid` where nothing was applied
/// nearer than reach() to the rim; the part beyond five standard deviations is distributed within. O(cells ·
/// spread / cell). The result is the same for any number of threads.
std::vector<double> drifted(const std::vector<double>& laid, const CellGrid& grid, const DoseDrift& drift);

}  // namespace tramline::coverage
