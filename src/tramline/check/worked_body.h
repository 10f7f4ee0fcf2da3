#pragma once
// How the swaths lie over the body: what each is the first to work of it, and what lies beyond it.

#include <vector>

#include "tramline/check/worked_parts.h"

namespace tramline::check {

/// "Body" is the land it is asked for: of tracks the plan's body, of tracks and passes all land.
struct WorkedBody {
  std::vector<double>
      useful_m2;          ///< by piece: of the body, what neither it nor a piece before has worked yet
  double covered_m2 = 0;  ///< their sum: of the body, what the swaths cover
  Region beyond;          ///< what of the swaths lies outside the body; parts may overlap
};

/// What the parts work of land, by piece or headland pass: `owners` in all. By polygon booleans, part by part
/// and only where an edge of the body or another part is in the way: most swaths lie in the middle of the
/// body and next to one another. O(n log n + k) for n parts and k overlays.
WorkedBody worked_on(const Region& land, const std::vector<WorkedPart>& parts, std::size_t owners,
                     double width_m);

/// How much of a layer is body that no swath works, m². Each of its polygons is held against the parts near
/// it.
double left_within_m2(const Region& layer, const Region& body, const std::vector<WorkedPart>& parts);

}  // namespace tramline::check
