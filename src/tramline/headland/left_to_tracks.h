#pragma once
// Ground of headlands that no pass works, but tracks can.

#include "tramline/headland/headland.h"

namespace tramline {

/// Of the ground that no pass works: where a swath as wide as the machine's has room and a track of
/// `least_length_m` would fit, on `clear`, land far enough from boundaries for tracks to end in any direction
/// without crossing them. Corners as wide as half a swath and narrower strips are not in it: nothing could
/// work them without working as much again. Lies in `headland.ground`; parts of it may touch the body.
Region left_to_tracks(const HeadlandAndBody& headland, const Region& clear, double width_m,
                      double least_length_m);

}  // namespace tramline
