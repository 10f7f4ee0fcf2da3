#pragma once
// The rectangle that most drawn fields, ponds and cuts of the tests are.

#include "tramline/geometry/polygon/region.h"

namespace tramline::testing_support {

/// Along the axes, anticlockwise from its south-west corner.
inline Ring box(double min_x, double min_y, double max_x, double max_y) {
  return {{min_x, min_y}, {max_x, min_y}, {max_x, max_y}, {min_x, max_y}};
}

}  // namespace tramline::testing_support
