#pragma once
// The ends of tracks from which the machine can only back out.

#include <vector>

#include "tramline/model/machine.h"
#include "tramline/model/track.h"
#include "tramline/turns/room/allowed_land.h"

namespace tramline {

/// Marks the ends of pieces in driving order from which there is no way off (has_way_off()), and counts them.
/// Ends before a passable obstacle that the same track crosses are none. O(n) room tests for n pieces.
int mark_stops(const AllowedLand& land, const Machine& machine, std::vector<TrackPiece>& pieces);

}  // namespace tramline
