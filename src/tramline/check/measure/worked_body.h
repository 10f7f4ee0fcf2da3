#pragma once
// How the swaths lie over the body: what each is the first to work of it, and what lies beyond it.

#include <vector>

#include "tramline/check/measure/worked_parts.h"

namespace tramline::check {

/// "Body" is the land it is asked for: of tracks the plan's body, of tracks and passes all land.
struct WorkedBody {
  std::vector<double>
      useful_m2;          ///< by piece: of the body, what neither it nor a piece before has worked yet
  double covered_m2 = 0;  ///< their sum: of the body, what the swaths cover
};

/// What the parts work of land, by piece or headland pass: `owners` in all. Ground that several work is that
/// of the first. By the cells of ground_cells.h. O(n log n) for n edges.
WorkedBody worked_on(const Region& land, const std::vector<WorkedPart>& parts, std::size_t owners);

}  // namespace tramline::check
