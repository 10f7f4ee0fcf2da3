#pragma once
// Headland ground that no pass works but tracks can.

#include "tramline/headland/headland.h"

namespace tramline {

/// Ground narrower than a swath is also left to tracks where it is at least this share of the width wide, and
/// this many times as long as a track has to be: the track works some land again, which costs less than
/// leaving the ground.
inline constexpr double kNarrowestStrip = 1.0 / 3;
inline constexpr double kNarrowStripLength = 2;

/// Land far enough from boundaries for tracks.
struct ClearLand {
  Region for_track_ends;   ///< tracks may end here in any direction without crossing a boundary that has a
                           ///< headland
  Region for_track_sides;  ///< tracks may also reach over the sides of their ground here
};

/// The parts of the ground that no pass works where tracks fit: with room for a whole swath and a track of
/// `least_length_m` on the land for track ends, or long narrower strips on the land for track sides. Corners
/// and narrower parts are not included: nothing could work them without working as much again. Lies in
/// `headland.ground`; parts of it may touch the body.
Region ceded_to_tracks(const HeadlandAndBody& headland, const ClearLand& clear, double width_m,
                       double least_length_m);

/// The parts of a region in which no track fits, by the same measure: neither as wide as a swath and
/// `least_length_m` long nor narrower and longer.
Region without_room_for_tracks(const Region& region, double width_m, double least_length_m);

}  // namespace tramline
