#pragma once
// What every path that a machine drives has to keep.

#include <gtest/gtest.h>

#include <cmath>

#include "tramline/geometry/path/path.h"

namespace tramline {

/// Segments that join without a kink, none tighter than the radius.
inline void expect_drivable(const Path& path, double radius_m, bool closed = false) {
  ASSERT_FALSE(path.empty());
  EXPECT_GE(smallest_radius(path), radius_m * (1 - 1e-9));
  for (std::size_t i = 0; i < path.size(); ++i) {
    if (i + 1 == path.size() && !closed) break;
    const PathSegment &a = path[i], &b = path[(i + 1) % path.size()];
    EXPECT_LT(distance(a.to, b.from), 1e-9) << i;
    EXPECT_LT(distance(direction_at_end(a), direction_at_start(b)), 1e-6) << i;
  }
}

}  // namespace tramline
