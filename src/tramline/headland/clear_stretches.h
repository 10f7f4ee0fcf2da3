#pragma once
// Passes that end at what is in their way.

#include <vector>

#include "tramline/geometry/offset/offset_rings.h"

namespace tramline {

/// The stretches of a path that keep their distance from all offset boundaries, on the free side; the path
/// itself where all of it does. Ends are found to a micrometre, stretches in steps of `step_m`. O(s·m) for s
/// steps and m edges of the offset boundaries.
std::vector<Path> clear_stretches(const Path& path, const std::vector<OffsetBoundary>& offset_boundaries,
                                  double step_m);

}  // namespace tramline
