#pragma once
// Work that is interrupted on ground which is driven over.

#include <vector>

#include "tramline/coverage/drive/worked_step.h"
#include "tramline/geometry/polygon/region.h"

namespace tramline::coverage {

/// The quads without what lies on the region, in quads and triangles (a corner twice) that only touch.
/// O(quads · edges of the region, and their crossings). Precondition: convex quads.
std::vector<Quad> interrupted(const std::vector<Quad>& quads, const Region& region);

}  // namespace tramline::coverage
