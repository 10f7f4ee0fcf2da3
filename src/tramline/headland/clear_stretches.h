#pragma once
// Passes that end at what is in their way.

#include <vector>

#include "tramline/geometry/offset/offset_rings.h"
#include "tramline/headland/tolerances.h"

namespace tramline {

/// The stretches of a path that keep their distance from all offset boundaries, on the free side; the path
/// itself where all of it does. Ends are found to a micrometre, stretches in steps of `step_m`. O(s·m) for s
/// steps and m edges of the offset boundaries.
std::vector<Path> clear_stretches(const Path& path, const std::vector<OffsetBoundary>& offset_boundaries,
                                  double step_m);

/// A boundary and the distance that the edge of a swath has to keep from it, m; 0 where it may touch it. What
/// reaches into its sides by no more than `beside_m` is not in its way.
struct SwathLimit {
  Ring ring;
  double distance_m = 0;
  double beside_m = kBeside_m;
};

/// An open path extended straight at its end as far as its swath, `width_m` wide and with flat ends, keeps
/// its distance from the boundaries, but by no more than `most_m`. O(n) for n edges.
Path driven_on(Path path, const std::vector<SwathLimit>& limits, double width_m, double most_m);

/// An open path extended straight at both ends in the same way. O(n) for n edges.
Path driven_to_the_end(Path path, const std::vector<SwathLimit>& limits, double width_m, double most_m);

}  // namespace tramline
