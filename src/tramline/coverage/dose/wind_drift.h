#pragma once
// The share of a spray that the wind takes along.

#include <vector>

#include "tramline/coverage/dose/dose_settings.h"
#include "tramline/model/cell_grid.h"
#include "tramline/model/dose_map.h"

namespace tramline::coverage {

DoseDrift drift_of(const WindSettings& wind);

/// By how much anything is moved, m: the grid has to reach that far beyond what was laid.
Box reach(const DoseDrift& drift, double cell_m);

/// What the cells get of the drifting share of `laid`: the amount of a cell, taken as even over it, moved and
/// spread, and summed over the cells it comes to. Its sum is drift.share times that of `laid` where nothing
/// was laid nearer than reach() to the rim; what lies further than five standard deviations from the middle
/// is laid within. O(cells · spread / cell). The same whatever the threads.
std::vector<double> drifted(const std::vector<double>& laid, const CellGrid& grid, const DoseDrift& drift);

}  // namespace tramline::coverage
