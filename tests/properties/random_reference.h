#pragma once
// Reference lines of curved tracks in random scenes.

#include <optional>
#include <vector>

#include "tramline/geometry/path/extended_line.h"
#include "tramline/geometry/path/smoothed_line.h"

namespace tramline {

/// The line smoothed for a machine of that turning radius and extended beyond the box; nullopt where the
/// machine cannot drive along it, or where it crosses itself when it is extended.
inline std::optional<Path> reference_beyond(const Box& box, const std::vector<Point>& line, double radius_m,
                                            double tolerance_m) {
  const SmoothedOrRefused driven = try_smoothed(line, radius_m, tolerance_m);
  if (!driven.smoothed) return std::nullopt;
  const Extended whole = extended(driven.smoothed->path, box);
  if (whole.blocked_at_start || whole.blocked_at_end) return std::nullopt;
  return whole.path;
}

}  // namespace tramline
