#pragma once
// Mean, spread and histogram of a map.

#include <vector>

#include "tramline/model/cell_grid.h"
#include "tramline/model/dose_map.h"

namespace tramline::coverage {

/// What cells hold, m² and amounts; as many as the grid has.
struct CellContents {
  std::vector<double> laid;     ///< where it was laid
  std::vector<double> drifted;  ///< brought by the wind; empty: no wind
  std::vector<double> covered_m2;
  std::vector<double> field_m2;   ///< empty: no field
  std::vector<double> missed_m2;  ///< of the field; empty: no field
};

/// What was laid in a cell lies evenly on the cell's covered ground, what drifted on all of the cell: of a
/// cell that the field's edge, or the edge of a swath, passes through only that part counts which is on the
/// ground. Cells weigh as much as they have ground; those of which less than half is ground count in amounts
/// and the mean only, as a drop on a sliver makes any rate. Bins are 10 % of the reference wide with a
/// multiple of it in their middle; the last has all from 245 %. `nominal_per_ha`: the reference; NaN: the
/// mean is. O(cells).
DoseFigures figures_of(const CellContents& cells, const CellGrid& grid, double nominal_per_ha);

/// Of the amount in each cell, that on its ground.
std::vector<float> amounts_on_ground(const CellContents& cells, const CellGrid& grid);

}  // namespace tramline::coverage
