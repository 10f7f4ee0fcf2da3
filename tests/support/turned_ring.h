#pragma once
// Land that lies another way.

#include <cmath>

#include "tramline/geometry/polygon/region.h"

namespace tramline::testing_support {

/// Turned to the left about the origin.
inline Ring turned(const Ring& ring, double by_rad) {
  const double c = std::cos(by_rad), s = std::sin(by_rad);
  Ring out;
  for (const Point& p : ring) out.push_back({c * p.x - s * p.y, s * p.x + c * p.y});
  return out;
}

}  // namespace tramline::testing_support
