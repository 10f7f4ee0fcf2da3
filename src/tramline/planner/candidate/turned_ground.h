#pragma once
// The land of a search in the turned plane of one direction.

#include "tramline/planner/candidate/candidate.h"
#include "tramline/tracks/straight_tracks.h"

namespace tramline {

/// Obstacles and, where it is hard, the field's boundary.
TurnedGround turned_ground(const SearchTask& task, const TrackFrame& frame);

}  // namespace tramline
