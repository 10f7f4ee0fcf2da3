#pragma once
// Interruption of work on land that is only driven over.

#include <vector>

#include "tramline/coverage/drive/worked_step.h"
#include "tramline/geometry/polygon/region.h"

namespace tramline::coverage {

/// The parts of the quads outside the region, as quads and triangles (with one corner twice) that do not
/// overlap. O(quads · edges of the region, and their crossings). Precondition: convex quads.
std::vector<Quad> interrupted(const std::vector<Quad>& quads, const Region& region);

}  // namespace tramline::coverage
