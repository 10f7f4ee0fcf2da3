#pragma once
// Ground of headlands that no pass works, but tracks can.

#include "tramline/headland/headland.h"

namespace tramline {

/// Ground narrower than a swath is left to tracks, too, where it is at least so wide, as a share of the
/// width, and so much longer than a track has to be: the track works the rest again, which costs less.
inline constexpr double kNarrowestStrip = 1.0 / 3;
inline constexpr double kNarrowStripLength = 2;

/// Land far enough from boundaries for tracks.
struct ClearLand {
  Region to_end;       ///< in any direction, without crossing a boundary that has a headland
  Region to_lie_over;  ///< that they may lie over the sides of their ground, too
};

/// Of the ground that no pass works: where a swath as wide as the machine's has room and a track of
/// `least_length_m` would fit on the land to end on, or long strips that are narrower on that to lie over.
/// Corners and what is narrower still are not in
/// it: nothing could work them without working as much again. Lies in `headland.ground`; parts of it may
/// touch the body.
Region ceded_to_tracks(const HeadlandAndBody& headland, const ClearLand& clear, double width_m,
                       double least_length_m);

}  // namespace tramline
