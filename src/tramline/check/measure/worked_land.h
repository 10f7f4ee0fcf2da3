#pragma once
// The land that swaths work: the area that each is the first to work.

#include <vector>

#include "tramline/check/measure/worked_parts.h"

namespace tramline::check {

/// The areas worked of some land: of the plan's body by tracks, or of all land by tracks and passes.
struct WorkedLand {
  std::vector<double> useful_m2;  ///< by piece: the area of the land that it is the first to work
  double covered_m2 = 0;          ///< their sum: the area of the land that the swaths cover
};

/// The areas of land that the parts work, by owner (piece or headland pass), `owners` in all. Land that
/// several work counts for the first. Computed from the cells of overlay_cells.h. O(n log n) for n edges.
WorkedLand worked_on(const Region& land, const std::vector<WorkedPart>& parts, std::size_t owners);

}  // namespace tramline::check
