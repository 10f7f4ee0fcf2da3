#pragma once
// Mean, spread and histogram of a dose map.

#include <vector>

#include "tramline/model/cell_grid.h"
#include "tramline/model/dose_map.h"

namespace tramline::coverage {

/// Areas, m², and amounts of all cells; each list has as many as the grid.
struct CellContents {
  std::vector<double> laid;     ///< amount applied directly
  std::vector<double> drifted;  ///< amount brought by the wind; empty: no wind
  std::vector<double> covered_m2;
  std::vector<double> field_m2;   ///< empty: no field
  std::vector<double> missed_m2;  ///< of the field; empty: no field
};

/// The amount applied in a cell counts as spread evenly over the cell's covered land, the drifted amount over
/// the whole cell. Of a cell crossed by the field's edge or the edge of a swath only the part on the ground
/// (the field or, without a field, covered land) counts. Cells are weighted by their area of ground; those of
/// which less than half is ground count in amounts and the mean only, because on a sliver any rate may
/// result. Bins are 10 % of the reference wide and centred on multiples of 10 %; the last has all from 245 %.
/// `nominal_per_ha`: the reference; NaN: the mean is the reference. O(cells).
DoseFigures figures_of(const CellContents& cells, const CellGrid& grid, double nominal_per_ha);

/// The part of each cell's amount that lies on its ground.
std::vector<float> amounts_on_ground(const CellContents& cells, const CellGrid& grid);

}  // namespace tramline::coverage
