#pragma once
// What one pair of tracks, on both sides of a reference at one distance, can follow and where it is joined.

#include <vector>

#include "tramline/geometry/front.h"
#include "tramline/geometry/parallel.h"

namespace tramline {

/// An arc about `place` that joins the end of one stretch to the beginning of another one.
struct TrackJoin {
  std::size_t before = 0;  ///< indices into TrackLevel::stretches
  std::size_t after = 0;
  FrontCorner corner;
};

struct TrackLevel {
  double distance_m = 0;
  Intervals stretches;  ///< places whose swath is nearest to them and that are not too tight to drive
  Intervals wide;       ///< places with room for a disc of radius ρ on the far side
  std::vector<TrackJoin> joins;
  Intervals lost;  ///< what of the stretches lies beyond a join: cut off by its arc
};

TrackLevel track_level(const Contour& contour, double distance_m, const TrackLimits& limits, Sides sides);

}  // namespace tramline
