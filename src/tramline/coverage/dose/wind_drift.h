#pragma once
// The share of a spray that the wind takes along.

#include <vector>

#include "tramline/geometry/angle.h"
#include "tramline/model/cell_grid.h"
#include "tramline/model/dose_map.h"

namespace tramline::coverage {

/// A simple model (docs/dose.md). `share` of the amount is droplets so fine that they go with the wind: they
/// fall from the height of the nozzle at their terminal velocity – 0.27 m/s for droplets of 0.1 mm (Gunn and
/// Kinzer 1949, Journal of Meteorology 6:243–248) – and land wind · height / velocity downwind, spread
/// normally about that in every direction with `spread` of the shift as standard deviation. The rest lands
/// where it was laid.
struct WindSettings {
  double speed_mps = 0;
  Heading from;  ///< where it comes from
  double share = 0.05;
  double height_m = 0.5;
  double fall_mps = 0.27;
  double spread = 0.3;
};

DoseDrift drift_of(const WindSettings& wind);

/// By how much anything is moved, m: the grid has to reach that far beyond what was laid.
Box reach(const DoseDrift& drift, double cell_m);

/// What the cells get of the drifting share of `laid`: the amount of a cell, taken as even over it, moved and
/// spread, and summed over the cells it comes to. Its sum is drift.share times that of `laid` where nothing
/// was laid nearer than reach() to the rim; what lies further than five standard deviations from the middle
/// is laid within. O(cells · spread / cell). The same whatever the threads.
std::vector<double> drifted(const std::vector<double>& laid, const CellGrid& grid, const DoseDrift& drift);

}  // namespace tramline::coverage
