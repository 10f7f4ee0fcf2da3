#pragma once
// One side of a track beside what is in its way, in the frame of a detour.

#include <optional>
#include <vector>

#include "tramline/avoidance/detour/curved_detour_path.h"
#include "tramline/avoidance/detour/detour_frame.h"
#include "tramline/tracks/laid_pieces.h"

namespace tramline {

/// A straight track is y = 0 of the frame; a curved one touches the x axis at the middle of what is in the
/// way.
struct TrackSide {
  double width_m = 0;
  Passing side = Passing::kLeft;
  DetourFrame frame;
  std::optional<TrackLine> curve;  ///< the track, where it is not straight
};

/// `blocked`: positions along the track between which the obstacle lies.
TrackSide track_side(const StripGrid& grid, const Track& track, Interval blocked, Passing side);

/// The box, in the detour's frame, of the track's swath between two positions: sampled every metre where the
/// track is curved.
Box reach_between(const TrackSide& track, Interval range);

/// The way round all discs on this side that leaves the track and returns to it, tangentially, by arcs of
/// `radius_m`; nullopt where there is none. Obstacles are not filled in. See detour_path() and
/// curved_detour_path().
std::optional<TrackDetour> detour_beside(const TrackSide& track, const std::vector<KeepOut>& discs,
                                         double radius_m, HullCorners corners);

}  // namespace tramline
