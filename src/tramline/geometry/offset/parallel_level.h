#pragma once
// What one pair of tracks, on both sides of a reference at one distance, can follow and where it is joined.

#include <vector>

#include "tramline/geometry/offset/offset_front.h"
#include "tramline/geometry/offset/parallel.h"

namespace tramline {

/// An arc about `place` that joins the end of one stretch to the beginning of another one.
struct TrackJoin {
  std::size_t before = 0;  ///< indices into ParallelLevel::stretches
  std::size_t after = 0;
  OffsetCorner corner;
};

struct ParallelLevel {
  double distance_m = 0;
  /// Places whose swath is nearest to them and that are not too tight to drive, trimmed where they are
  /// joined; what was trimmed comes last. Not sorted.
  Intervals stretches;
  Intervals wide;  ///< places with room for a disc of radius ρ on the far side
  std::vector<TrackJoin> joins;
  Intervals lost;  ///< what of the stretches the arcs' swaths reach, or the corner that an arc cuts off
};

ParallelLevel parallel_level(const Contour& contour, double distance_m, const TrackLimits& limits,
                             Sides sides);

}  // namespace tramline
