#pragma once
// What was worked, by the definitions taken word for word, bit of ground by bit of ground.

#include <vector>

#include "tramline/coverage/drive/worked_step.h"
#include "tramline/geometry/polygon/region.h"
#include "tramline/model/coverage.h"

namespace tramline::testing {

/// Cuts the plane into slabs between all heights at which an edge ends or two cross, and every slab into
/// trapezoids between edges. Each trapezoid lies wholly inside or outside every quad: how often it was
/// worked, and whether it was repeated, follows from the list of the steps that work it. In doubles, without
/// any rounding to a grid. O(n² + slabs · edges).
CoverageAreas literal_coverage(const Region& field, const std::vector<coverage::WorkedStep>& steps);

}  // namespace tramline::testing
