#include "tramline/geometry/path/shifted_path.h"

#include <cmath>

#include "tramline/geometry/tolerances.h"

namespace tramline {

std::optional<Path> shifted(const Path& path, double right_m, double least_radius_m) {
  Path out;
  out.reserve(path.size());
  for (const PathSegment& segment : path) {
    PathSegment moved{segment.from + right_m * right_of(direction_at_start(segment)),
                      segment.to + right_m * right_of(direction_at_end(segment)), 0};
    if (!segment.straight()) {
      // To the right is away from the centre of an arc that turns left.
      const double radius_m = 1 / std::abs(segment.curvature) + (segment.curvature > 0 ? right_m : -right_m);
      // One just as tight as allowed has lost a little in becoming a curvature and back.
      if (radius_m < least_radius_m * (1 - kRounding_share)) return std::nullopt;
      moved.curvature = std::copysign(1 / radius_m, segment.curvature);
    }
    if (!out.empty()) moved.from = out.back().to;
    out.push_back(moved);
  }
  return out;
}

}  // namespace tramline
