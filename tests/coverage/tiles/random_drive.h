#pragma once
// Random drives: bars that a machine of several sections drags over the ground.

#include <random>
#include <vector>

#include "tramline/coverage/drive/worked_step.h"
#include "tramline/geometry/polygon/region.h"

namespace tramline::testing {

struct Drive {
  Region field;  ///< with holes, or empty
  std::vector<coverage::WorkedStep> steps;
};

/// About `length` fixes: ways with bends, turns on the spot, standing, reversing, jumps, another width or
/// other sections on the way, the same way again, and passes that touch the one before exactly. The length of
/// steps is 0.02 to 10 m, all of one size within a drive. Somewhere within `far_m` of the origin.
Drive random_drive(std::mt19937_64& random, int length, double far_m);

/// The same drive, moved.
Drive moved(Drive drive, Point by);

}  // namespace tramline::testing
