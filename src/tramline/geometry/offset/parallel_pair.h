#pragma once
// The pair of tracks at one distance on both sides of a reference: the stretches they can follow and the arcs
// that join these.

#include <vector>

#include "tramline/geometry/offset/offset_front.h"
#include "tramline/geometry/offset/parallel.h"

namespace tramline {

/// An arc about the corner's point that joins the end of one stretch to the beginning of another one.
struct TrackJoin {
  std::size_t before = 0;  ///< indices into ParallelPair::stretches
  std::size_t after = 0;
  OffsetCorner corner;
};

struct ParallelPair {
  double distance_m = 0;
  /// Positions that are the nearest ones to their swath and not too tight to drive, trimmed where they are
  /// joined; trimmed-off parts come last. Not sorted.
  Intervals stretches;
  Intervals wide;  ///< positions with room for a disc of radius ρ on the far side
  std::vector<TrackJoin> joins;
  Intervals lost;  ///< parts of the stretches that arcs' swaths reach or that lie in a cut-off corner
};

ParallelPair parallel_pair(const Contour& contour, double distance_m, const TrackLimits& limits, Sides sides);

}  // namespace tramline
